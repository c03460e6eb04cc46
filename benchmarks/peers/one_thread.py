"""One thread on one core for all that is compared, the program too. To be imported before NumPy and
the peers, which read the environment only once."""

import os

for _variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[_variable] = "1"


def pin():
    """Onto the last core, since the first one serves most interrupts. What is started later is
    there, too."""
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
