# Everything runs in .venv, made from constraints.txt: the same versions everywhere.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin

.PHONY: setup demo test lint bench desk live soak motion speech sheets docs site clean

setup: $(VENV)/.ready

$(VENV)/.ready: pyproject.toml constraints.txt
	$(PYTHON) -c 'import sys; sys.exit("FaceScript needs Python 3.11 or later; run: make PYTHON=python3.12" if sys.version_info < (3, 11) else 0)'
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --constraint constraints.txt --editable '.[dev]'
	touch $@

demo: setup
	$(BIN)/facescript build examples/evening.face -o evening.mp4 -o evening.svg
	@echo "evening.mp4 is the film; open evening.svg in a browser for the same, drawn live"

# A file of tests stays in one process: what its fixtures build is built once.
test: setup
	tests/chromium.sh
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports
	$(BIN)/python -m pytest -n 2 --dist loadfile

lint: setup
	$(BIN)/ruff format .
	$(BIN)/ruff check --fix .
	$(BIN)/mypy
	$(BIN)/lint-imports

bench: setup
	@for script in benchmarks/[a-z]*.py; do $(BIN)/python $$script; done

desk: setup
	$(BIN)/python benchmarks/desk

live: setup
	$(BIN)/python benchmarks/live

soak: setup
	SOAK_MINUTES=10 $(BIN)/python benchmarks/live soak flood

motion: setup
	$(BIN)/python benchmarks/motion

speech: setup
	$(BIN)/python benchmarks/speech

# After a change that is meant: look at the pages in build/sheets before the new sheets are committed.
sheets: setup
	$(BIN)/python tests/sheet/renew.py

docs: setup
	$(BIN)/python docs/make_diagnostics.py
	$(BIN)/python docs/make_pictures.py

# The manual as a site in build/site, to be opened from there or served; it wants no network once its packages are here.
site: setup
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --constraint constraints.txt --editable '.[docs]'
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --strict --config-file docs/website/mkdocs.yml

.PHONY: vscode
# Wants node 20 or later; its packages come from the npm registry, in the versions of package-lock.json.
vscode: setup
	$(BIN)/python editors/make_textmate.py
	mkdir -p build
	cp LICENSE editors/vscode/LICENSE
	cd editors/vscode && npm ci && npx --no-install vsce package --no-dependencies --allow-missing-repository --out ../../build/facescript.vsix

.PHONY: playground
# Wants node, as `vscode` does: the editor in the page of `facescript preview`, with colours and help.
playground:
	cd editors/web && npm ci && node bundle.mjs

clean:
	rm -rf $(VENV) build dist editors/vscode/dist editors/*/node_modules facescript/preview/page/editor.*
