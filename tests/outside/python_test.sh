#!/usr/bin/env bash
# The Python package: its wheel is made from the build folder and installed into an environment of its own; its tests run
# there, and docs/PYTHON.md, pasted, prints what it shows.
# usage: tests/outside/python_test.sh BUILD MMVERIFY LIBRARY       LIBRARY: examples/subject, compiled; exit code 77: skipped
set -euo pipefail

(($# == 3)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
build=$(readlink -f -- "$1") program=$(readlink -f -- "$2") library=$(readlink -f -- "$3")
root=$(readlink -f -- "$(dirname -- "${BASH_SOURCE[0]}")/../..")
python=/usr/bin/python3
skip() { echo "SKIPPED: $*: ./run install wheel"; exit 77; }
[[ -e $build/delivery/python/left-out ]] && skip "the Python package is not built: $(<"$build/delivery/python/left-out")"
for module in numpy pip setuptools venv wheel; do
  "$python" -c "import $module" 2>/dev/null || skip "no $module of Debian's Python"
done

TMPDIR=$(mktemp -d)
export TMPDIR PYTHONDONTWRITEBYTECODE=1
unset PYTHONPATH
trap 'rm -r "$TMPDIR"' EXIT
fail() { echo "FAILED: $*"; exit 1; }
MMVERIFY_BUILD=$build "$python" -m pip wheel "$root/delivery/python" --no-build-isolation --no-deps --no-index \
  --disable-pip-version-check --wheel-dir "$TMPDIR" >"$TMPDIR/log" 2>&1 || { cat "$TMPDIR/log"; fail "the wheel"; }
WHEEL=$(echo "$TMPDIR"/mmverify-*.whl)
export WHEEL
"$python" -m venv --system-site-packages "$TMPDIR/env"
"$TMPDIR/env/bin/pip" install --quiet --no-deps --no-index --disable-pip-version-check "$WHEEL"
(cd "$root/delivery/python/tests" && MMVERIFY_PROGRAM=$program MMVERIFY_EXAMPLE=$library "$TMPDIR/env/bin/python" -m unittest)

# The document: blocks of sh are commands, plain blocks their output.
mkdir "$TMPDIR/installed"
ln -s "$(dirname -- "$program")" "$TMPDIR/installed/bin"
page=$root/docs/PYTHON.md
script=$(sed -n '/^```sh$/,/^```$/{/^```/d;p}' "$page")
# Debian's Python, whichever comes first on the PATH.
MMVERIFY=$TMPDIR/installed bash -euo pipefail -c "${script//python3 -m venv/$python -m venv}" >"$TMPDIR/printed" 2>"$TMPDIR/log" ||
  { cat "$TMPDIR/printed" "$TMPDIR/log"; fail "docs/PYTHON.md"; }
awk '/^```/ { plain = !inside && $0 == "```"; inside = !inside; next } inside && plain' "$page" >"$TMPDIR/shown"
[[ -s $TMPDIR/shown ]] || fail "docs/PYTHON.md shows no output"
diff "$TMPDIR/shown" "$TMPDIR/printed" || fail "docs/PYTHON.md prints something else than it shows"
echo "the wheel, its tests and docs/PYTHON.md: done"
