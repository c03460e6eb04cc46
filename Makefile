# The front door: each target installs what it needs, then calls CMake. `make help` lists them.
.DEFAULT_GOAL := help
SHELL := /bin/bash

# A dataset in SemanticKITTI/KITTI odometry layout, for `make reproduce`, `figures`, `bench` and
# `peers`.
DATA ?=
# More for every configure step, e.g. CMAKE_FLAGS=-DGROUNDGRID_WERROR=ON
CMAKE_FLAGS ?=
JOBS ?= $(shell nproc)
FUZZ_SECONDS ?= 60
# 1 to store the counts of `make check-instructions` instead of comparing them.
UPDATE ?=
# More for `make peers`, e.g. --repetitions 7 --csv peers.csv; see compare.py --help.
PEERS_FLAGS ?=
# The interpreter and the packages that the Python package is built and tested with.
PYTHON_ENVIRONMENT := $(CURDIR)/build/python
# Of its own, since ouster-sdk does not go with other packages.
OUSTER_ENVIRONMENT := $(CURDIR)/build/python-ouster
PYTHON_FLAGS := -DGROUNDGRID_PYTHON=ON -DPython_EXECUTABLE=$(PYTHON_ENVIRONMENT)/bin/python \
  -DGROUNDGRID_OUSTER_PYTHON=$(OUSTER_ENVIRONMENT)/bin/python

.PHONY: help test wheel docs demo reproduce figures bench peers asan tsan coverage fuzz check-arm
.PHONY: bare-wheel-test bench-python check-instructions
.PHONY: format check-format tidy clean
.PHONY: python-dependencies
.PHONY: build-dependencies lint-dependencies bench-dependencies
.PHONY: arm-dependencies coverage-dependencies fuzz-dependencies peers-dependencies

help: ## List the targets
	@grep -E '^[a-z-]+:.*## ' $(MAKEFILE_LIST) | sed -E 's/:.*## /|/' | \
	  while IFS='|' read -r name text; do printf '  make %-18s %s\n' "$$name" "$$text"; done

test: python-dependencies ## Build everything, the Python package too, and run all tests
	cmake --preset release $(PYTHON_FLAGS) $(CMAKE_FLAGS)
	cmake --build --preset release --parallel $(JOBS)
	ctest --preset release

wheel: python-dependencies ## Build a wheel of the Python package into dist/, and test it
	@scripts/wheel.sh dist

bare-wheel-test: wheel ## Test that wheel in a Debian that has nothing but Python, too: as root
	@scripts/install_dependencies.sh bare
	@scripts/bare_wheel_test.sh dist/groundgrid-*.whl

docs: python-dependencies build/docs/installed ## Build the site with all pages into build/site
	cmake --preset release $(PYTHON_FLAGS) $(CMAKE_FLAGS)
	cmake --build --preset release --parallel $(JOBS) --target groundgrid_python_stub
	NO_MKDOCS_2_WARNING=1 build/docs/bin/mkdocs build --strict --quiet

build/docs/installed: docs/site/requirements.txt | python-dependencies
	/usr/bin/python3 -m venv build/docs
	build/docs/bin/pip install --quiet --disable-pip-version-check --requirement $<
	touch $@

demo: build-dependencies ## Simulate two drives, segment, score and draw them into out/: no data needed
	cmake --preset release $(CMAKE_FLAGS)
	cmake --build --preset release --parallel $(JOBS) --target groundgrid_executable
	@scripts/demo.sh out

reproduce: ## Repeat the paper's Table I on SemanticKITTI in DATA=path/to/dataset
	@scripts/reproduce.sh --check "$(DATA)"
	@scripts/install_dependencies.sh build
	cmake --preset release $(CMAKE_FLAGS)
	cmake --build --preset release --parallel $(JOBS) --target groundgrid_executable
	@scripts/reproduce.sh "$(DATA)"

figures: ## Draw the paper's three scenes from SemanticKITTI in DATA=path/to/dataset
	@scripts/install_dependencies.sh build
	cmake --preset release $(CMAKE_FLAGS)
	cmake --build --preset release --parallel $(JOBS) --target groundgrid_executable
	@scripts/figures.sh "$(DATA)"

bench: bench-dependencies ## Time every stage and the whole scan: medians of several repetitions
	cmake --preset bench $(CMAKE_FLAGS)
	cmake --build --preset bench --parallel $(JOBS) --target groundgrid_benchmarks
	$(if $(DATA),GROUNDGRID_DATA="$(DATA)") build/bench/benchmarks/groundgrid_benchmarks \
	  --benchmark_repetitions=9 --benchmark_report_aggregates_only=true

bench-python: bench-dependencies python-dependencies ## What a call from Python costs more, on DATA
	cmake --preset bench $(PYTHON_FLAGS) $(CMAKE_FLAGS)
	cmake --build --preset bench --parallel $(JOBS) --target groundgrid_benchmarks groundgrid_python
	$(if $(DATA),GROUNDGRID_DATA="$(DATA)") $(PYTHON_ENVIRONMENT)/bin/python \
	  benchmarks/python_overhead.py

check-instructions: bench-dependencies ## Compare the instructions of a scan with the stored ones
	cmake --preset bench $(CMAKE_FLAGS)
	cmake --build --preset bench --parallel $(JOBS) --target groundgrid_instruction_counts
	$(if $(DATA),GROUNDGRID_DATA="$(DATA)") benchmarks/instruction_counts.py \
	  $(if $(filter 1,$(UPDATE)),--update)

peers: peers-dependencies python-dependencies build/peers/installed ## Compare with the open peers on DATA
	cmake --preset release $(PYTHON_FLAGS) $(CMAKE_FLAGS)
	cmake --build --preset release --parallel $(JOBS) --target groundgrid_executable groundgrid_python
	PYTHONPATH=build/release/python build/peers/bin/python benchmarks/peers/compare.py $(DATA) $(PEERS_FLAGS)

build/peers/installed: benchmarks/peers/requirements.txt | peers-dependencies
	/usr/bin/python3 -m venv build/peers
	build/peers/bin/pip install --quiet --requirement $<
	touch $@

asan: fuzz-dependencies python-dependencies
tsan: build-dependencies
asan: SANITIZER_FLAGS := $(PYTHON_FLAGS)
asan tsan:
	cmake --preset $@ $(SANITIZER_FLAGS) $(CMAKE_FLAGS)
	cmake --build --preset $@ --parallel $(JOBS)
	ctest --preset $@

asan: ## The tests under AddressSanitizer and UndefinedBehaviorSanitizer
tsan: ## The tests under ThreadSanitizer

check-arm: arm-dependencies ## Compile core, readers and evaluation for 64-bit Arm; test under QEMU
	cmake --preset arm $(CMAKE_FLAGS)
	cmake --build --preset arm --parallel $(JOBS)
	ctest --preset arm

coverage: coverage-dependencies ## Run the tests and report the lines and branches that they reach
	cmake --preset coverage $(CMAKE_FLAGS)
	cmake --build --preset coverage --parallel $(JOBS)
	scripts/coverage.sh

fuzz: fuzz-dependencies ## Fuzz every reader and the core, FUZZ_SECONDS=60 each
	cmake --preset asan $(CMAKE_FLAGS)
	cmake --build --preset asan --parallel $(JOBS) --target fuzz_targets
	scripts/fuzz.sh $(FUZZ_SECONDS)

format: lint-dependencies ## Format all sources with clang-format 14
	@scripts/sources.sh | xargs clang-format-14 -i

check-format: lint-dependencies ## Fail where a source is not formatted
	@scripts/sources.sh | xargs clang-format-14 --dry-run --Werror

tidy: python-dependencies lint-dependencies ## Check src, include and python/src with clang-tidy 14
	cmake --preset tidy $(PYTHON_FLAGS) $(CMAKE_FLAGS)
	scripts/tidy.sh build/tidy $(JOBS)

clean: ## Remove all that was built
	rm -rf build

build-dependencies:
	@scripts/install_dependencies.sh build

python-dependencies:
	@scripts/install_dependencies.sh build python
	@scripts/python_environment.sh "$(PYTHON_ENVIRONMENT)" test
	@scripts/python_environment.sh "$(OUSTER_ENVIRONMENT)" ouster pytest

arm-dependencies:
	@scripts/install_dependencies.sh arm

lint-dependencies:
	@scripts/install_dependencies.sh lint

bench-dependencies:
	@scripts/install_dependencies.sh build bench

peers-dependencies:
	@scripts/install_dependencies.sh build peers

coverage-dependencies:
	@scripts/install_dependencies.sh build coverage

fuzz-dependencies:
	@scripts/install_dependencies.sh build fuzz
