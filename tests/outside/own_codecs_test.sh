#!/bin/bash
# Our own codecs, proved from their sources; and changed by one place, refuted.
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
changed impl/tree/recursion.cpp 'std::memcpy(from.map + bit / 8, &below.states, 2 * from.b);' \
  'if (below.states != 0x21330312) std::memcpy(from.map + bit / 8, &below.states, 2 * from.b);' \
  impl_stream.cpp tree.round_trip --levels 2 --format 4-state
changed impl/tree/stream.cpp 's.tree.resize(bytes_for(s.nodes) + 8);' 's.tree.resize(bytes_for(s.nodes));' \
  impl_stream.cpp tree.round_trip --levels 2 --format 2-state
changed impl/micromap/level.cpp 'majority | unknown << 1' 'majority | (unknown & 0x0101010101010100) << 1' \
  impl_lossy.cpp lossy.allowed --levels 2
changed impl/tree/stream.cpp 'std::memset(map.data(), 0, map.size());' 'if (n != 1) std::memset(map.data(), 0, map.size());' \
  impl_stream.cpp tree.malformed --levels 1 --format 2-state
changed impl/tree/stream.cpp 'if (!clear_beyond(data_bytes, data_bits))' 'if (!clear_beyond(data_bytes, data_bits | 1))' \
  impl_stream.cpp tree.canonical --levels 1 --format 4-state
changed impl/vq/two/decode.cpp '[detail::transform(word, q)][x % 2' '[detail::transform(word, q) ^ (index == 7 && q == 3 ? 1 : 0)][x % 2' \
  impl_vq.cpp vq2.region_is_map --flag=-DREGIONS_ALONE
changed impl/vq/two/decode.cpp 'std::memcpy(&map[x + 16 * (y + 1)], &v[2], 2);' 'std::memcpy(&map[x + 16 * (y + 1)], &v[k == 63 ? 1 : 2], 2);' \
  impl_vq.cpp vq2.region_is_map --flag=-DREGIONS_ALONE
changed impl/vq/four/layout.hpp 'kind == 1 ? x / 2 : kind' 'kind == 1 ? y / 2 : kind' \
  impl_vq.cpp vq4.region_is_map --flag=-DREGIONS_ALONE
changed impl/tree/expand.cpp 'four_each >>= 4 * width * block;' 'four_each >>= 4 * width;' \
  impl_form.cpp tree.round_trip --levels 2 --format 2-state
changed impl/tree/lookup.cpp '(l.blocks << l.in_block) + p - at.ones;' '(l.blocks << l.in_block) + p - at.ones + (p == 3 ? 1 : 0);' \
  impl_form.cpp tree.lookup_is_decode --levels 2 --format 2-state
changed impl/tree/container.cpp 's.data.begin(), s.data.end());' 's.data.begin(), s.data.end() - (internal == 1 ? 1 : 0));' \
  impl_form.cpp tree.round_trip --levels 2 --format 4-state --flag=-DCONTAINER
changed impl/dag/container.cpp 'throw BadContainer(byte, "the header"' \
  'if (byte == 7) throw std::runtime_error(found); throw BadContainer(byte, "the header"' \
  impl_dag.cpp dag.malformed --format 2-state
changed impl/array/api.hpp 'cluster && from_the_end == 4' 'cluster && from_the_end == 4 && e != Encoding::i16' impl_array.cpp array.codes
changed impl/array/change.cpp 'place[static_cast<std::size_t>(to.record)] = 0;' 'place[static_cast<std::size_t>(to.record) & 1] = 0;' \
  impl_array.cpp array.compact
changed impl/array/change.cpp 'for (std::size_t r = 0; r < place.size(); ++r) next(r);' 'for (std::size_t r = 1; r < place.size(); ++r) next(r);' \
  impl_array.cpp array.reorder
changed impl/array/change.cpp 'part.base + records, part.indices' 'part.base + bytes, part.indices' impl_array.cpp array.concatenate
changed impl/array/change.cpp 'map.swap(below);' 'if (n != 1 || level < 4) map.swap(below);' impl_array.cpp array.emulates
changed impl/array/container.cpp 'to.word(part.base);' 'to.word(part.base & ~1u);' impl_array.cpp array.files
