"""The paper's two evaluations: labels against true ones, and heights against a reference."""

from ._core import SegmentationMetrics, compare_terrain, to_semantic_kitti

__all__ = ["SegmentationMetrics", "compare_terrain", "to_semantic_kitti"]
