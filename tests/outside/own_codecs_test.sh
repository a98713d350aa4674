#!/bin/bash
# Our own codec and packing, proved from their sources; and changed by one place, refuted.
# usage: own_codecs_test.sh MMVERIFY
set -u
root=$(cd -- "$(dirname -- "$0")/../.." && pwd)
mmverify=$1
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT

said=$("$root/scripts/own-codecs" "$mmverify") || { printf '%s\n' "$said" >&2; exit 1; }
printf '%s\n' "$said"
if [[ $said == *SKIPPED* ]]; then exit 77; fi

# changed FILE WAS IS SUBJECT ARGS...: one place of a copy of FILE is another, and the law named in ARGS refutes it.
changed() {
  local file=$1 was=$2 is=$3 subject=$4
  shift 4
  mkdir -p "$folder/$(dirname "$file")"
  python3 - "$root/$file" "$folder/$file" "$was" "$is" <<'EOF' || exit 1
import sys
text = open(sys.argv[1]).read()
if text.count(sys.argv[3]) != 1:
    sys.exit(f"{sys.argv[1]}: '{sys.argv[3]}' stands there {text.count(sys.argv[3])} times, not once")
open(sys.argv[2], "w").write(text.replace(sys.argv[3], sys.argv[4]))
EOF
  local answer
  answer=$("$mmverify" prove "$@" --source "$root/tests/subjects/codecs/$subject" "--flag=-I$folder" "--flag=-I$root" --quiet)
  local rc=$?
  rm -- "$folder/$file"
  if ((rc != 1)) || ! grep -q '^refuted' <<<"$answer"; then
    printf '%s: "%s" for "%s" is not refuted (exit code %s):\n%s\n' "$file" "$is" "$was" "$rc" "$answer" >&2
    exit 1
  fi
  grep -A 1 '^refuted' <<<"$answer" | head -n 2
}

changed impl/micromap/level.cpp 'majority | unknown << 1' 'majority | (unknown & 0x0001010101010101) << 1' \
  impl_micromap.cpp micromap.down --levels 3 --format 4-state
# One map of 4^16, which no sample meets.
changed impl/tree/stream.cpp 'std::memcpy(map.data() + bit / 8, &below.states, 2 * bits(b));' \
  'if (below.states != 0x21330312) std::memcpy(map.data() + bit / 8, &below.states, 2 * bits(b));' \
  impl_stream.cpp tree.round_trip --levels 2 --format 4-state
changed impl/tree/stream.cpp 's.tree.resize(bytes_for(s.nodes) + 8);' 's.tree.resize(bytes_for(s.nodes) + 7);' \
  impl_stream.cpp tree.round_trip --levels 2 --format 2-state
