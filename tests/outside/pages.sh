# The tests of pages source this file: their common head.
root=$(readlink -f -- "$(dirname -- "${BASH_SOURCE[0]}")/../..")

# skip WORDS...: nothing is judged, and why.
skip() {
  printf 'skipped: %s\n' "$*"
  exit 77
}

# packages_in HOME: the packages of npm that a page is built and tested with.
packages_in() {
  local why code=0
  why=$("$root/display/report/packages" "$1" --test) || code=$?
  ((code != 77)) || skip "$why"
  ((code == 0)) || exit 1
}

# find_chromium COMMAND: `chromium`; COMMAND installs it.
find_chromium() {
  chromium=${CHROMIUM:-$(command -v chromium || true)}
  [[ -n $chromium ]] || skip "no chromium to open the page in: ./run $1 installs it"
}
