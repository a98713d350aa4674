#!/usr/bin/env bash
# The Debian packages that ./run deb makes: lintian, what the program's package brings along, the licences in them, what it does
# alone and what both do.  They are unpacked rather than installed: this machine stays as it is.
# usage: tests/outside/deb_test.sh FOLDER      exit code 77: all but lintian's part was tested, and lintian is not here
set -euo pipefail

(($# == 1)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
packages=$(readlink -f -- "$1")
tests=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
fail() { echo "FAILED: $*"; exit 1; }
cd "$folder"
program=$(find "$packages" -name 'mmverify_*.deb') plugins=$(find "$packages" -name 'mmverify-plugins_*.deb')
source=$(find "$packages" -name 'mmverify_*.dsc')
[[ -s $program && -s $plugins && -s $source ]] || fail "$packages has not one mmverify, one mmverify-plugins and one source package"

# The size of all packages that come along on a machine with nothing but Debian's essential ones, in MB of 10^6 bytes.
readonly most=100
installed() { apt-get -s -o Dir::State::status="$folder/nothing" "${@:2}" install "$1" 2>"$folder/apt" | sed -n 's/^Inst \([^ ]*\).*/\1/p' | LC_ALL=C sort; }
: >nothing
kilobytes() {
  { dpkg-deb -f "$program" Package Installed-Size; grep -vx mmverify | xargs apt-cache show --no-all-versions; } |
    awk '/^Installed-Size: / {sum += $2} END {print sum}'
}
installed '?essential' --no-install-recommends >essential
if [[ ! -s essential ]]; then
  echo "SKIPPED: what the package brings along; apt knows no packages here: apt-get update"
else
  for recommends in --no-install-recommends --install-recommends; do
    installed "$program" "$recommends" >brought
    grep -qx mmverify brought || { cat apt; fail "apt cannot install $program"; }
    LC_ALL=C comm -13 essential brought >new
    size=$(($(kilobytes <new) * 1024 / 1000000))
    echo "apt-get $recommends: $(wc -l <new) packages, $size MB"
    [[ $recommends == --install-recommends ]] || ((size < most)) || fail "the package brings $size MB, of at most $most"
  done
fi

# Its documents, its manual page, and the licences of what is inside.
dpkg-deb -x "$program" alone
cp -r alone both
dpkg-deb -x "$plugins" both
documents=alone/usr/share/doc/mmverify
"$tests/installed_links.py" "$documents" alone/usr/share/man/man1/mmverify.1.gz || fail "links of the packaged documents"
cmp "$documents/copyright" both/usr/share/doc/mmverify-plugins/copyright
for inside in libboost1.81-dev nlohmann-json3-dev libcli11-dev libhwy-dev libcadical-dev llvm-14-dev uplot; do
  grep -qx "Files: inside/$inside" "$documents/copyright" || fail "the copyright file does not name $inside, whose code is inside"
done
grep -q 'Boost Software License' "$documents/copyright" || fail "the copyright file has no text of Boost's licence"
! grep -qx 'Files: inside/libsdsl-dev' "$documents/copyright" || fail "sdsl is inside, and its licence is the GPL"

# The program alone: it proves, and what is missing has the package's name.
alone=$folder/alone/usr/bin/mmverify both=$folder/both/usr/bin/mmverify
"$alone" prove index.in_range --levels 0..2 --quiet | tail -1
"$alone" scene -o scene.glb --quiet >/dev/null
cc -O2 -shared -fPIC -I alone/usr/include -o mine.so "$tests/../../examples/subject/subject.c"
"$alone" prove index.in_range --levels 0..2 --quiet --no-mutants --subject "$folder/mine.so" | tail -1
# names_plugins ARGS...: exit code 4, in one line, with the package's name.
names_plugins() {
  local code=0
  LD_LIBRARY_PATH=$folder/hidden "$alone" "$@" >said 2>&1 || code=$?
  ((code == 4)) && grep 'mmverify-plugins' said || { cat said; fail "exit code $code of mmverify $*, without the plugins"; }
}
# Libraries that this machine has and a bare one has not.
mkdir hidden
: >hidden/libembree3.so.3
: >hidden/libavif.so.15
cp "$tests/../../examples/subject/subject.c" codec.c
names_plugins render scene.glb
mkdir pictures
printf '\0\0\0\034ftypavif\0\0\0\0avifmif1miaf' >pictures/a.avif
names_plugins scene pictures --quiet
names_plugins prove --source codec.c
names_plugins prove index.floats --source codec.c --function index_of
echo 'uint index(uint level, float u, float v) { return 0u; }' >mine.glsl
if command -v glslangValidator >/dev/null; then
  names_plugins prove index.in_range --subject ./mine.glsl --levels 0..1
else
  echo "SKIPPED: a shader without the plugins; no glslangValidator: ./run install test"
fi

# Both.
! "$both" scene pictures --quiet >said 2>&1 && grep -q 'a.avif: an AVIF that cannot be decoded' said || fail "AVIF with the plugins"
"$both" render scene.glb --quiet >said || { cat said; fail "render with the plugins"; }
for program_of_plugins in mmverify-codec mmverify-source; do
  [[ -x both/usr/libexec/mmverify/$program_of_plugins && ! -e alone/usr/libexec/mmverify/$program_of_plugins ]] ||
    fail "$program_of_plugins is not in mmverify-plugins alone"
done
if command -v clang >/dev/null; then
  "$both" prove tree.canonical --source "$tests/../../examples/subject_tree/subject_tree.c" --levels 0 >said 2>&1 ||
    { cat said; fail "prove --source with the plugins"; }
  tail -1 said
else
  echo "SKIPPED: prove --source with the plugins; no clang: ./run install build"
fi

command -v lintian >/dev/null || { echo "SKIPPED: lintian's part; ./run install deb"; exit 77; }
lintian --allow-root --fail-on error,warning --info "$program" "$plugins" "$source" || fail "lintian has errors or warnings"
echo "lintian: no error, no warning"
