# make match    the learned team plays a scripted one (installs what it needs into .venv, without torch);
#               make match LEAGUE=legged-2001: the learned team of that league plays the team of 2001
# make test     run the tests            make lint          ruff and mypy
# make test-quick  run those that notice most of what an edit breaks (tests/quick.txt), in a minute or so
# make test-all    run the whole trainings, claims and long soaks as well, as continuous integration does
# make matrix   run test-quick on each Python of this machine, 3.10 to 3.13, with the oldest and the newest dependencies
# make bench    measure the speed        make tables        measure the tables of the pages
# make clean    remove what make built   make tables-check  replay a small part of each table
# make examples  run the examples of train/examples/: what needs more than `train` in an environment of its own
# make notebooks  make the notebooks from their pages and run them for their outputs: a quarter of an hour
# make pictures  draw the pictures of the pages       make docs  build the site into site/, strictly
# make sacks-table  measure every claim of Sacks 2001 and write baselines/sacks_2001/README.md
# make heinemann-table  the same of Heinemann et al. 2006, in baselines/heinemann_2006/README.md
# make lock     write requirements.lock anew: the newest versions that pyproject.toml allows, with their hashes
# make mutants  put slips into the code, drawn at random, and see which no test notices: a minute or two of a core each;
#               make mutants ARGS='--count 150 --seed 7', or ARGS=--mechanisms: those of the papers are switched off
# make fuzz     forge 20,000 saves and replays: none may end or hang the process that loads it (FILES=500 SEED=2: others)
#
# pip takes its settings from the environment and its own files; PYTHON=python3.12 chooses the interpreter of a new .venv.

PYTHON ?= python3
TORCH := torch==2.13.0
VENV := .venv
BIN := $(VENV)/bin
INNER := baselines agents train
export PYTHONDONTWRITEBYTECODE :=  # each process of the tests would read all sources anew
PARALLEL := -n auto --dist worksteal  # a process for each core; one that is done takes tests from the others

.PHONY: match test test-all test-quick matrix lint types bench pictures notebooks docs tables tables-check sacks-table heinemann-table mutants fuzz examples lock clean
.DELETE_ON_ERROR:

LEAGUE := middle-size-2006
TEAMS_legged-2001 := --home learned --away sacks-2001 --players 3
TEAMS_middle-size-2006 := --home learned-2006 --away heinemann-2006 --players 2 --pose particles

match: $(VENV)/.has-base
	$(BIN)/soccer evaluate --league $(LEAGUE) $(TEAMS_$(LEAGUE)) --matches 20 --minutes 4 \
		--seed 1 --threads 2 --out runs/match --anew --picture

test: $(VENV)/.has-train
	$(BIN)/python -m pytest $(PARALLEL) -m "not whole"

test-all: $(VENV)/.has-train
	$(BIN)/python -m pytest $(PARALLEL)

test-quick: $(VENV)/.has-train
	$(BIN)/python -m pytest $(PARALLEL) @tests/quick.txt

matrix: $(VENV)/.created
	$(BIN)/python -m pip install uv
	$(BIN)/python tests/matrix.py

# With torch, as its types decide what is right in train/.
lint: $(VENV)/.has-train types
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

# mypy names modules by the folders they lie in. These soft links lie as the packages are installed (package-dir in
# pyproject.toml); made anew each time, they follow files that come and go.
types:
	rm -rf build/types
	mkdir -p build/types/soccer_env
	@ln -s $(addprefix ../../../,$(filter-out $(INNER:%=soccer_env/%),$(wildcard soccer_env/*)) $(INNER)) \
		build/types/soccer_env

bench: $(VENV)/.has-base
	$(BIN)/soccer bench

tables: $(VENV)/.has-base
	$(BIN)/python -m soccer_env.train.pages.tables

tables-check: $(VENV)/.has-base
	$(BIN)/python -m soccer_env.train.pages.tables --check

pictures: $(VENV)/.has-pictures
	$(BIN)/python -m soccer_env.train.pages.pictures

notebooks: $(VENV)/.has-train
	$(BIN)/python -m soccer_env.train.pages.notebooks

docs: $(VENV)/.has-docs types
	NO_MKDOCS_2_WARNING=1 $(BIN)/python -m mkdocs build --strict

sacks-table: $(VENV)/.has-base
	$(BIN)/python -m soccer_env.train.pages.tables.sacks

heinemann-table: $(VENV)/.has-base
	$(BIN)/python -m soccer_env.train.pages.tables.heinemann

mutants: $(VENV)/.has-train
	$(BIN)/python tests/mutation/mutate.py $(ARGS)

FILES := 20000
SEED := 1

fuzz: $(VENV)/.has-train
	$(BIN)/python -m tests.fuzz.fuzz --files $(FILES) --seed $(SEED)

lock: $(VENV)/.has-base
	$(BIN)/python -m pip install uv
	echo 'setuptools>=77' | $(BIN)/uv pip compile pyproject.toml - --extra render --universal --python-version 3.10 \
		--generate-hashes --no-header --no-annotate --upgrade --output-file requirements.lock

# Each page of train/examples/ says in its first lines what it needs. STEPS=2000 runs them all in a shortened form;
# `make -k examples` goes on after one that fails, `make example-ppo_sb3` runs one.
HERE := ppo_cleanrl ppo_sb3
APART := cloning_minari ppo_rllib
EXAMPLE = bin/python -W ignore -m soccer_env.train.examples $* $(STEPS:%=--steps %)

examples: $(HERE:%=example-%) $(APART:%=example-%)

$(HERE:%=example-%): example-%: $(VENV)/.has-train
	$(VENV)/$(EXAMPLE)

$(APART:%=example-%): example-%: build/examples/%/.installed
	MINARI_DATASETS_PATH="$(CURDIR)/runs/minari" build/examples/$*/$(EXAMPLE)

build/examples/%/.installed: train/examples/%.py pyproject.toml
	"$(PYTHON)" -m venv $(@D)
	$(@D)/bin/python -m pip install $(TORCH)
	$(@D)/bin/python -m pip install $(TORCH) -e '.[train]' $$(sed -n 's/^Needs: //p' $<)
	touch $@

# Everything here can be made again, .venv included. runs/ holds results and stays.
clean:
	rm -rf $(VENV) build dist site *.egg-info .pytest_cache .mypy_cache .ruff_cache .hypothesis
	find soccer_env baselines agents train tests -name __pycache__ -type d -prune -exec rm -rf {} +

# Each stamp says that an installation into .venv was finished; a newer pyproject.toml or Makefile repeats it.
$(VENV)/.created:
	"$(PYTHON)" -m venv $(VENV)
	touch $@

# Every package at the version, and with one of the hashes, that the lock file says; setuptools, which builds, as well.
$(VENV)/.has-base: $(VENV)/.created pyproject.toml Makefile requirements.lock
	$(BIN)/python -m pip install --require-hashes -r requirements.lock
	$(BIN)/python -m pip install --no-deps --no-build-isolation -e .
	touch $@

$(VENV)/.has-pictures: $(VENV)/.has-base
	$(BIN)/python -m pip install -e '.[pictures]'
	touch $@

$(VENV)/.has-docs: $(VENV)/.has-base
	$(BIN)/python -m pip install -e '.[docs]'
	touch $@

# torch first and pinned: its version decides whether gigabytes of GPU libraries come along.
$(VENV)/.has-train: $(VENV)/.has-base
	$(BIN)/python -m pip install $(TORCH)
	$(BIN)/python -m pip install -e '.[dev,train,render]'
	touch $@
