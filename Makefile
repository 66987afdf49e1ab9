# Each target does its own set-up, once; `make` alone lists the targets.

PYTHON = python3
TRIALS = 1000
RUNS = 1000
OUT =
ARGS =
JOBS = 2

VENV = .venv
BIN = $(VENV)/bin
PIP_INSTALL = $(BIN)/python -m pip install --quiet --constraint constraints.txt
RUNTIME = $(VENV)/.runtime-installed
DEV = $(VENV)/.dev-installed
AGENTS = $(VENV)/.agents-installed
RIVALS = $(VENV)/.rivals-installed
DOCS = $(VENV)/.docs-installed
GL = $(VENV)/.gl-checked

# Handed over as environment variables, so that the shell never parses their text.
export TRIALS RUNS OUT

MAKEFLAGS += --no-builtin-rules --no-print-directory
.DEFAULT_GOAL = help
.DELETE_ON_ERROR:
.PHONY: help train reproduce live development test lint study smoke agents bench doctor \
	docs tutorial constraints clean

help: ## list the targets
	@sed -n 's/^\([a-z]*\):.*## \(.*\)/\1|\2/p' Makefile | \
	while IFS='|' read -r name text; do printf '  make %-12s %s\n' "$$name" "$$text"; done
	@printf '\n  ARGS="..." hands further options to the command behind a target;\n'
	@printf '  $(BIN)/prospect --help lists the commands that have no target.\n'

train: $(RUNTIME) $(GL) ## train on live physics: TRIALS=1000, OUT=<new folder>
	@$(BIN)/prospect train --trials="$$TRIALS" $${OUT:+--out="$$OUT"} $(ARGS)

reproduce: $(RUNTIME) ## the paper's experiment: RUNS=1000, TRIALS=1000, OUT=<folder>
	@$(BIN)/prospect reproduce --runs="$$RUNS" --trials="$$TRIALS" \
	$${OUT:+--out="$$OUT"} $(ARGS)

live: RUNS = 20
live: $(RUNTIME) $(GL) ## live runs to compare with, some hours: RUNS=20, OUT=<folder>
	@$(BIN)/prospect live-runs --runs="$$RUNS" --trials="$$TRIALS" \
	$${OUT:+--out="$$OUT"} $(ARGS)

development: $(RUNTIME) $(RIVALS) $(GL) ## who develops as infants do: RUNS=1000, OUT=<folder>
	@$(BIN)/prospect development --runs="$$RUNS" $${OUT:+--out="$$OUT"} $(ARGS)

test: lint $(GL) ## lint, then every fast test
	$(BIN)/python -m pytest -n $(JOBS) --dist worksteal $(ARGS)

lint: $(DEV) ## style, format and import contracts
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports

study: $(DEV) $(GL) ## the slow studies: actions, reaches, supervisor, learning
	$(BIN)/python -m pytest -n $(JOBS) --dist worksteal -m slow --timeout 7200 $(ARGS)

smoke: $(DEV) $(RIVALS) $(GL) ## whole commands, an installed package, a Ray cluster
	$(BIN)/python -m pytest -n $(JOBS) --dist worksteal -m smoke --timeout 600 $(ARGS)

agents: $(DEV) $(AGENTS) $(GL) ## install Stable-Baselines3, and let the examples train
	AGENTS=true $(BIN)/python -m pytest -m 'slow or not slow' tests/examples \
	tests/docs/test_scripts.py \
	tests/experiment/development/rivals/test_deep_runs.py $(ARGS)

bench: $(RUNTIME) $(GL) ## where simulated time goes, and what each learner costs
	@$(BIN)/prospect bench $(ARGS)

doctor: $(RUNTIME) ## what is wrong with this machine, and how to mend it
	@$(BIN)/prospect doctor $(ARGS)

# Not --quiet: what is not printed is no warning to it, and so no error.
docs: $(DOCS) ## the documentation as a site, in build/site; a warning is an error
	@NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --strict $(ARGS)
	@echo 'build/site/index.html; $(BIN)/mkdocs serve shows it while you write'

tutorial: $(DEV) $(GL) ## run the tutorial as it is written, a minute or two
	$(BIN)/python -m pytest -m slow tests/docs/test_tutorial.py $(ARGS)

constraints: ## pin in constraints.txt what .venv holds now
	@test -x $(BIN)/python || { echo 'error: no $(VENV) yet; run make test first' >&2; exit 2; }
	@{ sed -n '/^#/p' constraints.txt; \
	$(BIN)/python -m pip freeze --all --exclude-editable --exclude setuptools \
	--exclude prospect-mj; } > constraints.txt.new
	@sed 's/+cpu$$//' constraints.txt.new > constraints.txt
	@rm constraints.txt.new

clean: ## remove the virtual environment and every cache; runs/ stays
	rm -rf $(VENV) build dist .pytest_cache .ruff_cache .import_linter_cache .hypothesis
	find prospect_mj scripts tests examples docs -type d -name __pycache__ -prune -exec rm -rf {} +

$(RUNTIME): pyproject.toml constraints.txt
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
	echo 'error: $(PYTHON) must be Python 3.11 or newer;' \
	'name another one with: make PYTHON=python3.12 ...' >&2; exit 2; }
	@echo 'Setting up $(VENV) (once, a few minutes) ...'
	@$(PYTHON) -m venv $(VENV)
	@$(PIP_INSTALL) 'pip>=25.1'
	@$(PIP_INSTALL) --editable .
	@touch $@

$(DEV): $(RUNTIME)
	@$(PIP_INSTALL) --group dev
	@touch $@

$(DOCS): $(RUNTIME)
	@$(PIP_INSTALL) --group docs
	@touch $@

$(AGENTS): $(RUNTIME)
	@$(PIP_INSTALL) --group agents
	@touch $@

$(RIVALS): $(RUNTIME)
	@$(PIP_INSTALL) --editable '.[rivals]'
	@touch $@

$(GL): $(RUNTIME)
	@$(BIN)/python -m prospect_mj.cli.check_gl
	@touch $@
