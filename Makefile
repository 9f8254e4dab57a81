# SPDX-License-Identifier: MIT
# The commands of the project; each builds what it needs by a preset of CMakePresets.json, in
# build/<preset>. They are quiet when there is nothing to do.

MAKEFLAGS += --no-print-directory
.DEFAULT_GOAL := help
.PHONY: help run test check check-format check-tidy check-sanitize check-rules bench table1 campaign docs api format clean

help: ## show this list
	@sed -n 's/^\([a-z0-9-]*\):.*## /  make \1\t/p' Makefile | expand -t 22

run: ## build the program and fit the built-in orbit; writes a report into out/
	@tools/install_packages run
	@tools/build release hodograph_program
	@tools/run_example build/release/hodograph out

test: ## build and run all tests
	@tools/install_packages test
	@tools/build develop
	@tools/run_tests develop

check: check-format check-rules check-tidy check-sanitize ## format, rules, clang-tidy, sanitizers
	@echo "make check: all passed"

check-format: ## clang-format finds nothing to change
	@tools/install_packages check
	@tools/format --check

check-rules: ## the rules that tools/check_*.py enforce
	@tools/install_packages test
	@tools/check_all

check-tidy: ## clang-tidy over our sources and headers
	@tools/install_packages check
	@tools/tidy

check-sanitize: ## all tests under the address and undefined-behaviour sanitizers
	@tools/install_packages check
	@tools/build sanitize
	@tools/run_tests sanitize

bench: ## run every benchmark of bench/ and print its ratios
	@tools/install_packages python
	@tools/build release bench hodograph_python
	@tools/run_all build/release/bench
	@/usr/bin/python3 -B bench/python_evaluate.py build/release

table1: ## print the convergence table of the first paper, recomputed in 60 digits
	@tools/install_packages run
	@tools/build release table1
	@build/release/tools/table1

campaign: ## run the long random campaigns (minutes)
	@tools/install_packages test
	@tools/build develop campaign
	@build/develop/tests/campaign

docs: ## build the documentation site: build/docs/html/index.html
	@tools/install_packages docs
	@tools/build release hodograph_python
	@/usr/bin/python3 -B tools/build_docs.py build/release build/docs

api: ## rewrite the type stubs and the lists of public names
	@tools/install_packages test
	@tools/build develop hodograph_python
	@tools/make_stubs build/develop

format: ## let clang-format rewrite our sources
	@tools/install_packages check
	@tools/format

clean: ## remove everything that was built
	@rm -rf build
