#!/usr/bin/env bash
# CONTRIBUTING.md says what is so: each path that it names is there (TOPIC stands for one that has all), and each
# function that it names beside a file is in that file.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../.."
document=${1:-CONTRIBUTING.md}
failed=0 paths=0
fail() { echo "FAILED: $document: $*"; failed=1; }

while read -r path; do
  paths=$((paths + 1))
  there=${path//TOPIC/vq}
  [[ $path != docs/TOPIC.md ]] || there=docs/VQ.md
  [[ -e $there ]] || fail "$path is not there"
done < <(grep -oE '`[a-zA-Z0-9_./-]+/[a-zA-Z0-9_./-]*`|`CONTRIBUTING.md`' "$document" | tr -d '`' | sort -u)
((paths > 30)) || fail "only $paths paths found: the pattern is wrong"

# holds FILE WORD: the file has it, and the document says so.
holds() {
  grep -qF -- "$2" "$1" || fail "$1 has no $2"
  grep -qF -- "${2%%(*}" "$document" || fail "it does not speak of $2"
}
holds proofs/engine/cases.hpp 'on_numbered_cases('
holds proofs/vq/law_parts.hpp 'on_cases('
holds proofs/vq/laws.cpp 'laws('
holds proofs/vq/subject.hpp 'built_in_subjects('
holds proofs/vq/subject.hpp 'plugin_subject('
holds proofs/bake/subject.hpp 'Functions'
holds proofs/bake/subject.cpp 'built_in_subjects('
holds subjects/dock/entry_points.hpp 'Topic'
holds bench/table.hpp 'Column'
holds bench/result.hpp 'Result'
holds subjects/sdk/mmverify_subject.h 'mmverify_subject_t'
holds cmake/unite.cmake 'MMVERIFY_UNITE'
((failed == 0)) && echo "$document: $paths paths are there"
exit "$failed"
