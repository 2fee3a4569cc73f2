# Everything a developer does, by one word each; `make help` lists them.
# The first use of a target makes .venv and fills it from requirements/*.lock; stamp files keep the next uses quick.

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
SHELL := /bin/bash

VENV := .venv
BIN := $(VENV)/bin
# `make demo` needs the package alone; everything else the whole tool box.
CORE := $(VENV)/.core-installed
ALL := $(VENV)/.all-installed
# What Unity-Link is measured beside has an environment of its own: nothing else is to depend on it.
PEERS_VENV := $(VENV)/peers
PEERS := $(PEERS_VENV)/.installed
FUZZ_VENV := $(VENV)/fuzz
FUZZ := $(FUZZ_VENV)/.installed
MUTANTS_VENV := $(VENV)/mutants
MUTANTS := $(MUTANTS_VENV)/.installed
ROS_DISTRIBUTIONS := jazzy kilted
ROS := $(ROS_DISTRIBUTIONS:%=$(VENV)/ros-%/.installed)
PIP_INSTALL := -m pip install --quiet --disable-pip-version-check

# Python to build .venv with: any from 3.11. Choose another by `make venv PYTHON=...`.
PYTHON ?=
# More options for pytest, as in `make test PYTEST_ARGS="-k window"`.
PYTEST_ARGS ?=
# Tests run in so many processes side by side; 0 for none beside pytest's own.
PYTEST_PROCESSES ?= auto

.PHONY: help venv demo test test-all test-next coverage campaign fuzz mutants lint hooks check format bench bench-peers bench-beside bench-noise bench-ros bench-live ros-venvs table1 release docs docs-images docs-tables lock upgrade clean

help: ## list the targets
	@awk -F ':.*## ' '/^[a-z0-9-]+:.*## / { printf "  make %-12s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

venv: $(ALL) ## .venv with the package and every tool, in locked versions

demo: $(CORE) ## the virtual robot: read, write and subscribe, ten seconds, no hardware
	@$(BIN)/unity-link demo

# conftest.py says in which order tests run, and in which process; pytest-xdist would begin with the documents.
PYTEST := $(BIN)/python -m pytest --numprocesses $(PYTEST_PROCESSES) --no-loadscope-reorder
# The tests of `make test`. tests/test_quick_suite.py holds that they cover every feature.
QUICK := not slow and not campaign

test: $(ALL) ## the quick tests: every command, core, language and URL scheme; at most eight minutes
	@$(PYTEST) -m "$(QUICK)" $(PYTEST_ARGS)

test-all: $(ALL) ## every test but those of `make campaign`: proofs, simulations and compilations too; half an hour
	@$(PYTEST) $(PYTEST_ARGS)

# A later Python, of which the suite has no environment; installed by the system or by pyenv.
NEXT_PYTHON ?= $(firstword $(wildcard \
	$(patsubst %,%/python3.13,$(filter-out %/shims,$(subst :, ,$(PATH))) $(HOME)/.pyenv/versions/3.13.*/bin)))
NEXT_VENV := $(VENV)/next
NEXT := $(NEXT_VENV)/.installed
ifeq ($(NEXT_PYTHON),)
test-next:
	@echo "No python3.13 is installed: tests/capture, tests/protocol, tests/link and tests/spec did not run on it."
else
test-next: $(NEXT) ## quick tests of protocol, link and spec on Python 3.13, if it is installed
	@$(NEXT_VENV)/bin/python -m pytest --numprocesses $(PYTEST_PROCESSES) -m "$(QUICK)" tests/capture tests/protocol tests/link tests/spec $(PYTEST_ARGS)
endif

# Measuring takes about as long again as the tests do.
coverage: $(ALL) ## all tests of `make test-all`, and the lines that none of them runs
	@$(PYTEST) --cov --cov-report=term $(PYTEST_ARGS)

# Its tests are few and long: none waits for another in one process while the other has nothing to do.
campaign: $(ALL) ## the searches at length, and further configurations, devices and proofs, which `make test-all` leaves out
	@$(PYTEST) --dist worksteal --timeout 0 -m campaign $(PYTEST_ARGS)

# Seconds for each target.
FUZZ_SECONDS ?= 600
FUZZ_TARGETS ?= configuration frames gateway page recording serve session snooped spec client_c client_cpp
fuzz: $(FUZZ) ## search for bytes that something cannot take, ten minutes each; clients in C and C++ need clang
	@cd tests && for target in $(FUZZ_TARGETS); do \
		echo "$$target for $(FUZZ_SECONDS) s"; \
		../$(FUZZ_VENV)/bin/python -m fuzz $$target $(FUZZ_SECONDS) 2>../$(FUZZ_VENV)/log || { tail -40 ../$(FUZZ_VENV)/log; exit 1; }; \
		grep '^stat::number_of_executed_units' ../$(FUZZ_VENV)/log; \
	done

# More options for it, as in `make mutants MUTANTS_ARGS="--minutes 30"`; the next run goes on where one has ended.
MUTANTS_ARGS ?=
mutants: $(MUTANTS) ## put 500 wrongs into the protocol, and count those that no test finds; about an hour
	@cd tests && OPENBLAS_NUM_THREADS=1 ../$(MUTANTS_VENV)/bin/python -m mutants $(MUTANTS_ARGS)

lint: $(ALL) ## formatting, ruff, types, direction of the imports, plain English
	@$(BIN)/ruff format --check .
	@$(BIN)/ruff check .
	@$(BIN)/mypy
	@$(BIN)/lint-imports --cache-dir .cache/import-linter
	@cd tests && ../$(BIN)/python -m support.plain_english

hooks: ## have git refuse commits whose subject is empty or longer than 72 characters
	@python3 tests/support/commit_message.py

# The commit that a change is compared with; where the branch left main unless it is named.
BASE ?=
check: lint ## lint, and the quick tests of what a change touches: five minutes at most
	@cd tests && ../$(BIN)/python -m support.check $(BASE)

format: $(ALL) ## put the Python sources into the project's form
	@$(BIN)/ruff format .
	@$(BIN)/ruff check --fix .

# rclpy of PyPI has wheels for Python 3.12 alone; installed by the system or by pyenv.
ROS_PYTHON ?= $(firstword $(wildcard \
	$(patsubst %,%/python3.12,$(filter-out %/shims,$(subst :, ,$(PATH))) $(HOME)/.pyenv/versions/3.12.*/bin)))
ifeq ($(ROS_PYTHON),)
ros-venvs:
	@echo "No python3.12 is installed: rclpy of ROS 2 ($(ROS_DISTRIBUTIONS)) is not installed, and its tests do not run."
else
ros-venvs: $(ROS) ## rclpy of ROS 2 Jazzy and Kilted, if Python 3.12 is installed; `make test-all` runs their tests then
endif

bench: $(ALL) bench-peers ## measure, beside peers and REVISION too, and write benchmarks/RESULTS.md
	@$(BIN)/python -m benchmarks.beside $(REVISION) $(QUICKER)
	@$(BIN)/python -m benchmarks

bench-peers: $(PEERS) ## measure Unity-Link beside its peers, and write docs/performance.md
	@$(PEERS_VENV)/bin/python -m benchmarks.peers

# The revision that `make bench-beside` compares with, and what of it `make bench` compares.
REVISION ?= a3abcb1
QUICKER = concurrent_reads posts batch_posts alternating_samples command_time
bench-beside: $(ALL) ## measure this tree and REVISION in turn, and say what became slower
	@$(BIN)/python -m benchmarks.beside $(REVISION)

table1: $(ALL) ## the paper's experiment again, into benchmarks/TABLE1.md and plots; ten minutes
	@$(BIN)/python -m benchmarks.paper --output benchmarks

bench-ros: $(ALL) ## measure the bridges against their peers, and write benchmarks/BRIDGES.md
	@$(BIN)/python -m benchmarks.bridges

bench-noise: $(ALL) ## measure what noise leaves of a link's rate, and write benchmarks/NOISE.md
	@$(BIN)/python -m benchmarks.noise

bench-live: $(ALL) ## measure the live page in Chromium, and write benchmarks/LIVE.md
	@$(BIN)/python -m benchmarks.live_page

release: $(ALL) ## the wheel and the source archive in dist, tried in an empty environment
	@$(BIN)/python tests/support/release.py

docs: $(ALL) ## the documentation as HTML, warnings are errors
	@$(BIN)/sphinx-build --fail-on-warning --keep-going --quiet docs docs/_build/html
	@$(BIN)/python -m unity_link.cli.manual > docs/_build/unity-link.1
	@echo "docs/_build/html/index.html docs/_build/unity-link.1"

# Names of docs/images, to make those alone.
PICTURES ?=
docs-images: $(ALL) ## the pictures of the documentation, from what they show; two minutes
	@$(BIN)/python -m docs.images.make $(PICTURES)

docs-tables: $(ALL) ## the tables and listings of pages that follow from sources: cores, boards, Python interface
	@$(BIN)/python -m docs.tables

# Versions with hashes and nothing else: the files name neither a registry nor a machine.
UV_LOCK := $(BIN)/uv pip compile pyproject.toml --universal --python-version 3.11 --generate-hashes \
	--no-emit-index-url --no-emit-find-links --no-annotate --no-header --quiet
# lark-parser is an old form of lark, with modules of the same name; rclpy imports neither.
ROS_LOCK = $(subst --universal --python-version 3.11,--python-platform linux --python-version 3.12,$(UV_LOCK))
lock: $(ALL) ## lock what pyproject.toml asks for, keeping the versions that are locked
	$(UV_LOCK) $(UPGRADE) --group build -o requirements/core.lock
	$(UV_LOCK) $(UPGRADE) --constraints requirements/core.lock --all-extras \
		--group build --group dev --group docs --group gateware -o requirements/all.lock
	$(UV_LOCK) $(UPGRADE) --constraints requirements/all.lock --extra plot \
		--group build --group peers -o requirements/peers.lock
	$(UV_LOCK) $(UPGRADE) --constraints requirements/all.lock --extra live --extra record \
		--group build --group fuzz -o requirements/fuzz.lock
	$(UV_LOCK) $(UPGRADE) --constraints requirements/all.lock --extra ftdi --extra trio --extra usb \
		--group build --group mutants -o requirements/mutants.lock

	for distribution in $(ROS_DISTRIBUTIONS); do \
		$(ROS_LOCK) $(UPGRADE) --constraints requirements/all.lock --no-emit-package lark-parser \
			--group build --group ros-$$distribution -o requirements/ros-$$distribution.lock || exit 1; \
	done

upgrade: UPGRADE := --upgrade
upgrade: lock ## lock the newest versions

clean: ## remove what was built, .venv too
	rm -rf $(VENV) build dist docs/_build .cache .coverage .coverage.* htmlcov .hypothesis .mypy_cache .pytest_cache .ruff_cache
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

$(BIN)/python:
	@for python in $(or $(PYTHON),python3 python3.14 python3.13 python3.12 python3.11); do \
		"$$python" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || continue; \
		"$$python" -m venv $(VENV) && exit 0; \
		rm -rf $(VENV); \
		echo "$$python cannot make a virtual environment: install its venv module (Debian, Ubuntu: apt install python3-venv)." >&2; \
		exit 1; \
	done; \
	echo "Python 3.11 or later is needed, and $(or $(PYTHON),python3) is not: install it, or name one by: make PYTHON=/path/to/python3.11 $(MAKECMDGOALS)" >&2; \
	exit 1

# Without build isolation, so that the build back end is a locked one as well. Without dependencies, since a lock names all
# of them: pip before 23.3 holds an extra that a package asks for (coverage[toml]) to the newest release, not to the lock's.
define install
	@echo "Installing $(1) into $(2)"
	@$(2)/bin/python $(PIP_INSTALL) --no-deps --require-hashes --requirement $(1)
	@$(2)/bin/python $(PIP_INSTALL) --no-deps --no-build-isolation --editable .
endef

$(CORE): requirements/core.lock pyproject.toml | $(BIN)/python
	$(call install,requirements/core.lock,$(VENV))
	@touch $@

$(ALL): requirements/all.lock pyproject.toml | $(BIN)/python
	$(call install,requirements/all.lock,$(VENV))
	@touch $@ $(CORE)

$(PEERS): requirements/peers.lock pyproject.toml | $(BIN)/python
	@$(BIN)/python -m venv $(PEERS_VENV)
	$(call install,requirements/peers.lock,$(PEERS_VENV))
	@touch $@

$(NEXT): requirements/all.lock pyproject.toml
	@$(NEXT_PYTHON) -m venv $(NEXT_VENV)
	$(call install,requirements/all.lock,$(NEXT_VENV))
	@touch $@

$(FUZZ): requirements/fuzz.lock pyproject.toml | $(BIN)/python
	@$(BIN)/python -m venv $(FUZZ_VENV)
	$(call install,requirements/fuzz.lock,$(FUZZ_VENV))
	@touch $@

$(MUTANTS): requirements/mutants.lock pyproject.toml | $(BIN)/python
	@$(BIN)/python -m venv $(MUTANTS_VENV)
	$(call install,requirements/mutants.lock,$(MUTANTS_VENV))
	@touch $@

# By uv, which installs a hundred small packages in a fifth of pip's time.
$(ROS): $(VENV)/ros-%/.installed: requirements/ros-%.lock pyproject.toml | $(ALL)
	@echo "Installing requirements/ros-$*.lock into $(VENV)/ros-$*"
	@$(ROS_PYTHON) -m venv --without-pip $(VENV)/ros-$*
	@$(BIN)/uv pip install --quiet --python $(VENV)/ros-$* --no-deps --require-hashes --requirement requirements/ros-$*.lock
	@$(BIN)/uv pip install --quiet --python $(VENV)/ros-$* --no-deps --no-build-isolation --editable .
	@touch $@

# The gateware's targets; it also adds its own checks to `lint` and `test`.
-include gateware/gateware.mk
