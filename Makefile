# make demo    set everything up and run the spalling flyer plate
# make explore the library, impacts and decks in a browser
# make test    linter, layer contracts, type checker, tests
# make verify  the long tests and the built-in verification problems
# make docs    the documentation, in docs/_build/html
# make clean   remove what these made

VENV := .venv
BIN := $(VENV)/bin
SUITABLE := -c 'import sys; sys.exit(not (3, 11) <= sys.version_info[:2] < (3, 15))' >/dev/null 2>&1
PYTHON ?= $(shell for p in python3.13 python3.12 python3.11 python3.14 python3 python; do \
	$$p $(SUITABLE) && echo $$p && break; done)
WORKERS ?= 2
RUNS := runs
# pip would translate every file it installs, on one core; a process translates what it imports, a fifth of them, and keeps it
PIP = $(BIN)/python -m pip install --quiet --no-compile --editable
unexport PYTHONDONTWRITEBYTECODE

.PHONY: help demo explore lint style types test tests verify docs reference examples clean
.DEFAULT_GOAL := help

help:
	@sed -n 's/^# //p' Makefile | head -6

# one stamp for each set of requirements, older than pyproject.toml when it must be installed again
$(BIN)/python:
	@test -n "$(PYTHON)" && $(PYTHON) $(SUITABLE) || { echo "Python 3.11 to 3.14 is needed; name it with: make PYTHON=/path/to/python3"; exit 1; }
	$(PYTHON) -m venv $(VENV) || { echo "could not make $(VENV); on Debian and Ubuntu install python3-venv"; rm -rf $(VENV); exit 1; }

$(VENV)/.installed: pyproject.toml | $(BIN)/python
	$(PIP) .
	@touch $@

$(VENV)/.installed-explore: pyproject.toml | $(BIN)/python
	$(PIP) '.[explore]'
	@touch $@ $(VENV)/.installed

$(VENV)/.installed-test: pyproject.toml | $(BIN)/python
	$(PIP) '.[test]'
	@touch $@ $(VENV)/.installed

$(VENV)/.installed-docs: pyproject.toml | $(BIN)/python
	$(PIP) '.[docs]'
	@touch $@ $(VENV)/.installed

# a command starts a quarter of a second sooner where the sources need no translating
$(VENV)/.compiled: $(shell find src -name '*.py') | $(BIN)/python
	$(BIN)/python -m compileall -q src
	@touch $@

demo: $(VENV)/.installed $(VENV)/.compiled
	$(BIN)/hugoniot run examples/flyer.toml --out $(RUNS)/flyer.run --overwrite

explore: $(VENV)/.installed-explore $(VENV)/.compiled
	$(BIN)/hugoniot explore --work $(RUNS)

lint: style types

style: $(VENV)/.installed-test
	$(BIN)/ruff check .
	$(BIN)/lint-imports

types: $(VENV)/.installed-test
	$(BIN)/pyrefly check

test: $(VENV)/.installed-test
	$(MAKE) -j2 lint $(VENV)/.compiled $(VENV)/.imported
	$(MAKE) tests

# the larger libraries of the tests, so that they are translated once and beside the type checker, not by every worker at once
$(VENV)/.imported: $(VENV)/.installed-test
	$(BIN)/python -m compileall -q tests
	$(BIN)/python -W ignore -c "import emcee, h5netcdf, hypothesis, matplotlib.pyplot, numba, pytest, scipy.integrate, scipy.optimize, scipy.special, starlette.testclient, xarray"
	@touch $@

# to show values where an assert fails, each worker would first rewrite those of all tests, which takes as long as hundreds of tests
tests: $(VENV)/.installed-test $(VENV)/.compiled
	$(BIN)/python -m pytest -n $(WORKERS) --dist worksteal --assert=plain -m "not slow" \
		|| { echo "to see the values in the asserts that failed: $(BIN)/python -m pytest --last-failed"; exit 1; }

verify: $(VENV)/.installed-test
	$(BIN)/python -m pytest -n $(WORKERS) --dist worksteal -m slow
	$(BIN)/hugoniot verify

reference: $(VENV)/.installed
	$(BIN)/python docs/generate_deck_reference.py
	$(BIN)/python docs/materials/generate.py

docs: $(VENV)/.installed-docs
	$(BIN)/python -m sphinx -W --keep-going -b html docs docs/_build/html

# the decks of `hugoniot init` are the examples: one source, two places
examples:
	cp src/hugoniot/problem/templates/*.toml examples/

clean:
	rm -rf $(VENV) $(RUNS) docs/_build docs/auto_examples docs/generated build dist
