#!/usr/bin/env bash
# The workflow that docs/ci offers: valid YAML, and its own commands, in order, on the example subject: green, and red once the
# function is wrong.  Fetching sources and building mmverify itself, which need GitHub, are left out.
# usage: tests/outside/ci_workflow_test.sh MMVERIFY
set -euo pipefail

(($# == 1)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
PATH=$(dirname -- "$(readlink -f -- "$1")"):$PATH
source_root=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../..
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

# The shell commands of three steps, and the environment, as the file has them.
python3 - "$source_root/docs/ci/github-actions.yml" "$folder" <<'PYTHON'
import pathlib, sys
import yaml
workflow = yaml.safe_load(pathlib.Path(sys.argv[1]).read_text())
folder = pathlib.Path(sys.argv[2])
# YAML 1.1 reads the key `on` as true.
assert "push" in workflow.get("on", workflow.get(True)), "no trigger"
(folder / "environment").write_text("".join(f'export {k}="{v}"\n' for k, v in workflow["env"].items()))
steps = {step["name"]: step for job in workflow["jobs"].values() for step in job["steps"] if "name" in step}
for name in ("Build yours", "Prove", "Gate"):
    (folder / name).write_text(steps[name]["run"] + "\n")
for step in (step for job in workflow["jobs"].values() for step in job["steps"]):
    assert ("run" in step) != ("uses" in step), step
PYTHON

mkdir "$folder/project" "$folder/project/ci"
cp "$source_root/examples/subject/subject.c" "$folder/project/mine.c"
cat >"$folder/project/CMakeLists.txt" <<CMAKE
cmake_minimum_required(VERSION 3.25)
project(mine LANGUAGES C)
add_library(mine SHARED mine.c)
target_include_directories(mine PRIVATE "$source_root/subjects/sdk")
CMAKE
cd "$folder/project"
# shellcheck disable=SC1091  # written above
. "$folder/environment"
step() { bash -euo pipefail "$folder/$1"; }

step "Build yours" >/dev/null
# Every law to its highest level takes a minute; a few say as much of the commands.
sed -i 's/mmverify prove/& index.equals_reference index.in_range --levels 0..5/' "$folder/Prove"
step Prove >/dev/null
mmverify gate --baseline "$BASELINE" result.json --bless
step Gate
sed -i 's/if (j > n - 1) j = n - 1;/if (level == 5 \&\& j == 3) i ^= 1;/' mine.c
step "Build yours" >/dev/null
code=0
step Prove >/dev/null || code=$?
((code == 1)) || { echo "FAILED: the proof of a wrong function gives exit code $code"; exit 1; }
code=0
step Gate || code=$?
((code == 1)) || { echo "FAILED: the gate on a wrong function gives exit code $code"; exit 1; }
