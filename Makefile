# Everything here needs Python 3.11 or newer, a C++17 compiler and make; no root, no system MPI.
#
# A system MPI or Eigen instead of the ones that pip installs into .venv:
#   make demo MPICXX=/usr/bin/mpicxx EIGEN=/usr/include/eigen3

VENV    := .venv
BIN     := $(VENV)/bin
STAMP   := $(VENV)/.installed
PYTHON  ?= $(firstword $(foreach p,python3.11 python3.12 python3.13 python3.14 python3,$(shell command -v $(p) 2>/dev/null)))
# One more than two cores: some tests wait for a time limit, or for another process.
WORKERS ?= 3
PYTEST  := $(BIN)/python -m pytest -n $(WORKERS) --dist worksteal
CPP     = $(shell git ls-files '*.cpp' '*.hpp' ':!generated_examples' 2>/dev/null)

# Only what was said on the command line or in the environment is passed on.
ifneq ($(origin MPICXX),undefined)
export MPICXX
endif
ifneq ($(origin MPIEXEC),undefined)
export MPIEXEC
endif
ifneq ($(origin EIGEN),undefined)
export EIGEN
endif

# Tests start hundreds of processes: what Python compiles of adagen is kept for the next one.
unexport PYTHONDONTWRITEBYTECODE

.DEFAULT_GOAL := help
.PHONY: help setup demo test test-all test-narrow lint format golden paper bench charts docs clean

help: ## list the targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## / {printf "  make %-12s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

setup: $(STAMP) ## install adagen and all it needs into .venv

$(STAMP): pyproject.toml
	@test -n "$(PYTHON)" || { echo "error: no Python found; install Python 3.11 or newer" >&2; exit 3; }
	@"$(PYTHON)" -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	  { echo "error: $(PYTHON) is older than 3.11; say which one to use: make setup PYTHON=..." >&2; exit 3; }
	@command -v c++ >/dev/null || command -v g++ >/dev/null || command -v clang++ >/dev/null || \
	  { echo "error: no C++ compiler found; install g++" >&2; exit 3; }
	@test -x $(BIN)/python || "$(PYTHON)" -m venv $(VENV) || \
	  { echo "error: $(PYTHON) cannot make a virtual environment; on Debian install python3-venv" >&2; exit 3; }
	@echo "installing into $(VENV) (a minute or two, once)"
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[test]'
	@touch $@

demo: setup ## two robots: generate, build, run on 1 and 2 processes, check, time
	@$(BIN)/python -m adagen.cli.demo

test: setup lint ## lint and run the test suite
	$(PYTEST) $(ARGS)

test-all: setup lint ## the same with the slow tests
	$(PYTEST) -m 'slow or not slow' $(ARGS)

test-narrow: setup ## what is emitted, built for registers of 256 and of 128 bits
	for march in x86-64-v3 x86-64-v2; do MARCH=$$march $(PYTEST) tests/emit tests/runtime $(ARGS) || exit; done

lint: setup ## ruff, mypy, clang-format
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(if $(CPP),$(BIN)/clang-format --dry-run --Werror $(CPP))

format: setup ## let ruff and clang-format rewrite the sources
	$(BIN)/ruff check --fix-only .
	$(BIN)/ruff format .
	$(if $(CPP),$(BIN)/clang-format -i $(CPP))

golden: setup ## write generated_examples anew
	$(BIN)/python -m pytest --update-golden -n 0 tests

charts: setup ## accuracy beside speed of the shipped robots, into build/charts
	$(BIN)/python -m adagen chart generated_examples/models/*.urdf --out build/charts $(ARGS)

docs: setup ## the documents as a site with search, into build/site
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[docs]'
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --quiet

paper: setup ## the paper's tables and figures, predicted and measured here
	$(BIN)/python -m benchmarks.paper all

bench: setup ## adagen beside pinocchio, casadi and MuJoCo: tables and pictures in docs
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[test,bench]' || \
	  echo "note: not all peers could be installed; those that are here take part" >&2
	@$(BIN)/python -m benchmarks.bench $(ARGS)

clean: ## remove what was built (not .venv)
	rm -rf build dist .mypy_cache .pytest_cache .ruff_cache .hypothesis
	find adagen tests -name __pycache__ -type d -prune -exec rm -rf {} +
	@if [ -f generated_examples/Makefile ]; then $(MAKE) -s -C generated_examples clean; fi
