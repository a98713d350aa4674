#!/usr/bin/env bash
# action.yml and the workflows: valid YAML, each command is bash and one that is here, each input is used; and the action's three
# steps on a release of files, green, and red: another checksum, a wrong function, a baseline that is another.
# usage: tests/outside/action_test.sh MMVERIFY | --files        --files: the files alone, without the steps on a release
set -euo pipefail

(($# == 1)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
[[ $1 == --files ]] || program=$(readlink -f -- "$1")
root=$(readlink -f -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../..")
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
fail() { echo "FAILED: $*"; exit 1; }

python3 - "$root" "$folder" <<'PYTHON'
import pathlib, re, sys
import yaml
root, folder = map(pathlib.Path, sys.argv[1:])
action = yaml.safe_load((root / "action.yml").read_text())
text = (root / "action.yml").read_text()
for name in action["inputs"]:
    assert re.search(rf"\binputs\.{name}\b", text), f"input {name} is not used"
for name in re.findall(r"\binputs\.([a-z0-9]+)", text):
    assert name in action["inputs"], f"input {name} is not declared"
steps = action["runs"]["steps"]
assert all(("uses" in s) != ("run" in s) and ("run" not in s or s["shell"] == "bash") for s in steps)
for output in action["outputs"].values():
    step, _ = re.fullmatch(r"\$\{\{ steps\.(\w+)\.outputs\.(\w+) \}\}", output["value"]).groups()
    assert step in [s.get("id") for s in steps], step
for index, step in enumerate(s for s in steps if "run" in s):
    (folder / f"action-{index}.sh").write_text("#!/usr/bin/env bash\n" + step["run"] + "\n")
workflow = yaml.safe_load((root / ".github/workflows/release.yml").read_text())
# YAML 1.1 reads the key `on` as true.
assert workflow[True]["push"]["tags"] == ["v[0-9]+.[0-9]+.[0-9]+"]
# By night and for each change: a command of `run` or a file.
doors = re.findall(r"^  ([a-z-]+)\)", (root / "run").read_text(), re.M)
nightly, change = (yaml.safe_load((root / f".github/workflows/{name}.yml").read_text())["jobs"] for name in ("nightly", "change"))
commands = [job["command"] for job in nightly["run"]["strategy"]["matrix"]["include"]]
commands += [step["run"] for job in (nightly["bare"], change["checks"]) for step in job["steps"] if "run" in step]
for index, command in enumerate(commands):
    (folder / f"command-{index}.sh").write_text("#!/usr/bin/env bash\n" + command + "\n")
    for door in re.findall(r"[.]/run ([a-z-]+)", command):
        assert door in doors, f"./run has no {door}"
    for file in re.findall(r"(?:^|&& )((?:scripts|tests|[.]ci)/\S+)", command):
        assert (root / file).is_file(), f"no {file}"
# Other people's actions and images are named by their hash: a tag may be moved.
files = [root / "action.yml", *root.glob(".github/workflows/*.yml"), *root.glob("docs/ci/*.yml"), root / "delivery/packaging/Containerfile"]
for file in files:
    for used in re.findall(r"^[\s-]*uses: (.*)$", file.read_text(), re.M):
        assert re.fullmatch(r"[\w./-]+@[0-9a-f]{40} # v[0-9.]+", used), f"{file}: not by a commit's hash: {used}"
    for image in re.findall(r"^[\s-]*(?:container: |image: |FROM )(\S+)$", file.read_text(), re.M):
        assert re.fullmatch(r"[\w./-]+:[\w.-]+@sha256:[0-9a-f]{64}", image), f"{file}: not by an image's digest: {image}"
publish = workflow["jobs"]["publish"]
assert publish["permissions"] == {"contents": "write", "id-token": "write", "attestations": "write"}, publish["permissions"]
assert any(step.get("with", {}).get("subject-checksums") == "files/SHA256SUMS" for step in publish["steps"]), "nothing is attested"
gitlab = yaml.safe_load((root / "docs/ci/gitlab.yml").read_text())["mmverify"]
(folder / "gitlab.sh").write_text("#!/usr/bin/env bash\n" + "\n".join(gitlab["script"]) + "\n")
hooks = yaml.safe_load((root / ".pre-commit-hooks.yaml").read_text())
assert all(re.search(hook["files"], "a/b.glb") and not re.search(hook["files"], "glb.txt") for hook in hooks)
for name, job in workflow["jobs"].items():
    for index, step in enumerate(job["steps"]):
        assert ("uses" in step) != ("run" in step), step
        if "run" in step:
            (folder / f"workflow-{name}-{index}.sh").write_text("#!/usr/bin/env bash\n" + step["run"] + "\n")
PYTHON
grep -qx impl_index_test < <("$root/scripts/arm64-tests" --list) || fail "scripts/arm64-tests does not know impl_index_test"
for script in "$folder"/*.sh "$root"/delivery/packaging/action/* "$root"/scripts/bare-root-test "$root"/scripts/release/{bundle,deb,inside,make,notes,sysroot,tarball,try}; do
  bash -n "$script"
  ! command -v shellcheck >/dev/null || shellcheck --severity=warning "$script"
done
command -v shellcheck >/dev/null || echo "skipped: no shellcheck to read the steps with: ./run install test"

# The second step with a program that says what it was called with: all lines of an input count, and a run without a
# result is red.
mkdir "$folder/stub"
cat >"$folder/stub/mmverify" <<'STUB'
#!/bin/sh
printf '%s ' "$@" >"$0.said"
case " $* " in *" --help "*) exit 0 ;; esac
while [ $# -gt 1 ]; do [ "$1" != --json ] || echo '{}' >"$2"; shift; done
STUB
chmod +x "$folder/stub/mmverify"
stub() {
  local code=0
  env MMVERIFY_PROGRAM="$folder/stub/mmverify" MMVERIFY_SUBJECT="$folder/stub/mmverify" MMVERIFY_RESULTS="$folder/stub/results" \
    GITHUB_OUTPUT="$folder/stub/output" MMVERIFY_LAWS="$1" MMVERIFY_ARGS="$2" "$root/delivery/packaging/action/prove" >"$folder/log" || code=$?
  echo "$code $(<"$folder/stub/mmverify.said")"
}
said=$(stub $'index.in_range\nbake\n' $'--levels 0..2\n\n  --no-mutants\n')
[[ $said == '0 prove index.in_range bake --subject '*' --levels 0..2 --no-mutants ' ]] || fail "lines of inputs are lost: $said"
said=$(stub $'index\ttree\nvq' '')
[[ $said == *'prove index tree vq --subject '* ]] || fail "lines of inputs are lost: $said"
[[ $(stub index --help) == '2 '* ]] || fail "a run without a result is green"
grep -q 'no result was written' "$folder/log" || fail "it does not say that there is no result"

# The third step: patterns and names with blanks; one that matches nothing is red.
mkdir -p "$folder/assets/a b"
touch "$folder/assets/one.glb" "$folder/assets/a b/two.glb"
judge() {
  local code=0
  (cd "$folder" && env MMVERIFY_PROGRAM="$folder/stub/mmverify" MMVERIFY_RESULTS="$folder/stub/results" GITHUB_OUTPUT="$folder/stub/output" \
    MMVERIFY_FILES="$1" MMVERIFY_FILEARGS="$2" "$root/delivery/packaging/action/validate") >"$folder/log" || code=$?
  echo "$code $(<"$folder/stub/mmverify.said")"
}
said=$(judge $'assets/**/*.glb\n' '--api khr')
[[ $said == '0 validate ./assets/a b/two.glb ./assets/one.glb --json '*findings.json' --sarif '*findings.sarif' --api khr ' ]] || fail "files are lost: $said"
[[ $(judge 'assets/*.gltf' '') == '4 '* ]] || fail "a pattern without a file is green"
[[ $(judge '' '') == '2 '* ]] || fail "neither subject nor files is green"
grep -q '^sarif=' "$folder/stub/output" || fail "no output sarif"

# The maps, too: files without any are passed over, wrong ones are red.
cat >"$folder/stub/mmverify" <<'STUB'
#!/bin/sh
printf '%s\n' "$*" >>"$0.said"
case "$*" in
  *'check maps'*one.glb*) echo 'mmverify: one.glb: no primitive has a micromap' >&2; exit 2 ;;
  *'check maps'*) echo 'refuted bake.conservative'; exit 1 ;;
esac
STUB
: >"$folder/stub/mmverify.said"
MMVERIFY_MAPS=true judge 'assets/**/*.glb' '' >/dev/null
[[ $(tail -n 1 "$folder/log") == '::error::mmverify: maps: 1 files, 1 wrong' ]] || fail "wrong maps: $(tail -n 1 "$folder/log")"
grep -q '^check maps ./assets/a b/two.glb ' "$folder/stub/mmverify.said" || fail "two.glb's maps are not judged"

# Changed files alone: a GLB itself, another file with its folder.
mkdir -p "$folder/assets/c"
touch "$folder/assets/c/"{three.gltf,three.bin}
git -C "$folder" init -q
git -C "$folder" -c user.name=a -c user.email=a@b add assets
git -C "$folder" -c user.name=a -c user.email=a@b commit -qm first
first=$(git -C "$folder" rev-parse HEAD)
echo changed >"$folder/assets/c/three.bin"
changed() {
  : >"$folder/stub/mmverify.said"
  (cd "$folder" && env MMVERIFY_CHANGED=true MMVERIFY_BASE="$1" MMVERIFY_PROGRAM="$folder/stub/mmverify" MMVERIFY_RESULTS="$folder/stub/results" \
    GITHUB_OUTPUT="$folder/stub/output" MMVERIFY_FILES='assets/**/*.gl*' "$root/delivery/packaging/action/validate") >"$folder/log" || echo "exit code $?"
  cat "$folder/stub/mmverify.said"
}
[[ $(changed "$first") == 'validate ./assets/c/three.gltf --json '* ]] || fail "a changed .bin does not bring its .gltf: $(<"$folder/log")"
echo changed >"$folder/assets/one.glb"
[[ $(changed "$first") == 'validate ./assets/c/three.gltf ./assets/one.glb --json '* ]] || fail "a changed GLB is lost: $(<"$folder/log")"
git -C "$folder" -c user.name=a -c user.email=a@b commit -qam second
[[ -z $(changed "$(git -C "$folder" rev-parse HEAD)") ]] || fail "files without a change are judged"
[[ $(changed 0000000000000000000000000000000000000000) == *'two.glb'*'three.gltf'*'one.glb'* ]] || fail "without a commit to compare with not all are judged"
grep -q 'all files are judged' "$folder/log" || fail "it does not say that all files are judged"

[[ $1 != --files ]] || exit 0

# A release of files: the built program, in the archive's form.
version=$("$program" --version | sed -n '1s/mmverify //p')
case $(uname -m) in x86_64) machine=x86-64 ;; aarch64) machine=arm64 ;; *) echo "no release for $(uname -m)"; exit 0 ;; esac
name=mmverify-$version-linux-$machine
mkdir -p "$folder/release" "$folder/$name/bin" "$folder/$name/libexec/mmverify"
ln "$program" "$folder/$name/bin/mmverify" 2>/dev/null || cp "$program" "$folder/$name/bin/mmverify"
cp "$(dirname "$program")/mmverify-worker" "$folder/$name/libexec/mmverify/"
tar -C "$folder" -cf - "$name" | gzip -1 >"$folder/release/$name.tar.gz"
(cd "$folder/release" && sha256sum -- *.gz >SHA256SUMS)

mkdir "$folder/project" "$folder/temp"
cd "$folder/project"
cp "$root/examples/subject/subject.c" mine.c
build() { "${CC:-cc}" -O2 -shared -fPIC -I "$root/subjects/sdk" -o mine.so mine.c; }
build
export GITHUB_ACTION_PATH=$root RUNNER_TEMP=$folder/temp GITHUB_OUTPUT=$folder/output GITHUB_PATH=$folder/path
export MMVERIFY_VERSION=$version MMVERIFY_FROM=file://$folder/release MMVERIFY_SHA256=''
# step NUMBER: as the runner does it; its exit code.
step() {
  local code=0
  : >"$GITHUB_OUTPUT"
  bash -e "$folder/action-$1.sh" >"$folder/log" 2>&1 || code=$?
  echo "$code"
}
code=$(step 0)
((code == 0)) || { cat "$folder/log"; fail "the first step gives exit code $code"; }
MMVERIFY_PROGRAM=$(sed -n 's/^program=//p' "$GITHUB_OUTPUT")
export MMVERIFY_PROGRAM MMVERIFY_SUBJECT=mine.so MMVERIFY_LAWS='index.equals_reference index.in_range'
export MMVERIFY_ARGS='--no-mutants --levels 0..5' MMVERIFY_BASELINE='' MMVERIFY_RESULTS=results GITHUB_STEP_SUMMARY=$folder/summary
[[ -x $MMVERIFY_PROGRAM && $(<"$GITHUB_PATH") == "${MMVERIFY_PROGRAM%/*}" ]] || fail "no program: $MMVERIFY_PROGRAM"
code=$(step 1)
((code == 0)) || { cat "$folder/log"; fail "the second step gives exit code $code"; }
for output in json junit; do
  [[ -s $(sed -n "s/^$output=//p" "$GITHUB_OUTPUT") ]] || fail "no output $output"
done
grep -q 'proved' "$GITHUB_STEP_SUMMARY" || fail "the summary says nothing"
"$program" gate --baseline baseline.json results/result.json --bless >/dev/null
MMVERIFY_BASELINE=baseline.json
code=$(step 1)
((code == 0)) || { cat "$folder/log"; fail "the gate on its own baseline gives exit code $code"; }

# Red.
sed -i 's/if (j > n - 1) j = n - 1;/if (level == 5 \&\& j == 3) i ^= 1;/' mine.c
build
for MMVERIFY_BASELINE in '' baseline.json; do
  : >"$GITHUB_STEP_SUMMARY"
  code=$(step 1)
  ((code == 1)) || fail "a wrong function gives exit code $code, baseline '$MMVERIFY_BASELINE'"
  grep -q '^::error::refuted index.equals_reference level 0 case v:u=0,v=1 .* replay: ' "$folder/log" || fail "the counterexample is not shown"
  [[ $(sed -n 2p "$GITHUB_STEP_SUMMARY") == 'subject ./mine.so: refuted '* ]] || fail "the summary does not begin with the verdict"
  grep -q '^refuted index.equals_reference level 0 case' "$GITHUB_STEP_SUMMARY" || fail "the summary has no counterexample"
done
MMVERIFY_SUBJECT=missing.so
[[ $(step 1) == 4 ]] || fail "a library that is missing"
# The third step on a file that is none.
export MMVERIFY_FILES='*.glb' MMVERIFY_FILEARGS=''
echo '{"asset": {"version": "2.0"}}' >ours.glb
code=$(step 2)
((code == 0)) || { cat "$folder/log"; fail "the third step gives exit code $code"; }
for output in findings sarif; do
  [[ -s $(sed -n "s/^$output=//p" "$GITHUB_OUTPUT") ]] || fail "no output $output"
done
echo '{' >ours.glb
code=$(step 2)
((code == 1)) || fail "a file that is cut short gives exit code $code"
# Real maps, by the third step, by the job of docs/ci/gitlab.yml and by pre-commit's hook: right ones, then none listed.
rm ours.glb
mkdir assets
"$program" scene --level 2 --quiet -o assets/leaves.glb >/dev/null
export MMVERIFY_FILES='assets/**/*.glb' MMVERIFY_MAPS=true
code=$(step 2)
((code == 0)) || { cat "$folder/log"; fail "the third step on right maps gives exit code $code"; }
grep -q '^maps: 1 files, 0 wrong$' results/findings.txt || fail "the maps of a scene are not judged"
gitlab() {
  local code=0
  env -C "$folder/project" MMVERIFY_ASSETS=assets bash -e "$folder/gitlab.sh" >"$folder/log" 2>&1 || code=$?
  echo "$code"
}
[[ $machine == arm64 ]] || [[ $(gitlab) == 0 && -s maps.xml && -s findings.sarif ]] || { cat "$folder/log"; fail "GitLab's job on right maps is red"; }
hook() { "$program" $(sed -n 's/^  entry: mmverify //p' "$root/.pre-commit-hooks.yaml") "$@" >/dev/null; }
hook assets/leaves.glb || fail "the hook refuses a right file"
# The same bytes with another name in the list of extensions.
sed -i 's/"EXT_mesh_opacity_micromap"\]/"EXT_mesh_opacity_micromaq"]/' assets/leaves.glb
! hook assets/leaves.glb || fail "the hook takes a wrong file"
code=$(step 2)
((code == 1)) || fail "the third step on a wrong file gives exit code $code"
[[ $machine == arm64 || $(gitlab) == 1 ]] || fail "GitLab's job on a wrong file is green"
unset MMVERIFY_MAPS

# expect CODE WORDS: the first step, and what it complains of.
refused() {
  [[ $(step 0) == 4 ]] || fail "not refused: $1"
  grep -q "$1" "$folder/log" || { cat "$folder/log"; fail "it does not say: $1"; }
  [[ ! -s $GITHUB_OUTPUT ]] || fail "refused, and named all the same: $1"
}
MMVERIFY_SHA256=$(printf 'a%.0s' {1..64}) refused 'has SHA-256'
MMVERIFY_VERSION=9.9.9 refused 'cannot fetch'
MMVERIFY_FROM='' MMVERIFY_REPOSITORY=https://github.com/ refused 'names no repository'
# Of v1.2.3 and of 1.2.3 the same address; nothing answers at this one.
MMVERIFY_FROM='' MMVERIFY_REPOSITORY=http://localhost:1/owner/name MMVERIFY_VERSION=v$version \
  refused "cannot fetch http://localhost:1/owner/name/releases/download/v$version/"
MMVERIFY_VERSION=latest refused 'not one such as'
echo x >>"$folder/release/$name.tar.gz"
refused 'has SHA-256'
: >"$folder/release/SHA256SUMS"
refused 'has no SHA-256'
echo "action.yml: three steps on a release of files; what is wrong is refused"
