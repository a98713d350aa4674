#!/usr/bin/env bash
# prove --source of a codec: lines, exit codes, JSON and replays, with provers of one answer each; and, where the build has
# mmverify-codec, with the real one.
# usage: tests/outside/codec_command_test.sh MMVERIFY ROOT
set -euo pipefail

(($# == 2)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
mmverify=$(readlink -f -- "$1") root=$(readlink -f -- "$2")
command -v clang >/dev/null || { echo 'SKIPPED: no clang'; exit 77; }
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder"
failures=0
fail() { printf 'FAILED: %s\n' "$*"; failures=$((failures + 1)); }
tree=$root/examples/subject_tree/subject_tree.c
cp "$tree" right.c
sed 's|child < 4; ++child)|child < 3; ++child)|' "$tree" >wrong.c

# prover LINE...: a prover that runs these lines of a shell, and leaves a certificate without a step. A law for runs at odd
# addresses stays as it is.
prover() {
  printf '%s\n' '#!/usr/bin/env bash' 'if [[ $1 == --odd ]]; then exec cp "$2" "$3"; fi' 'for ((k = 1; k < $#; ++k)); do next=$((k + 1)); [[ ${!k} != --certificate ]] || : >"${!next}"; done' "$@" >prover
  chmod +x prover
}
export MMVERIFY_CODEC_PROVER=$folder/prover

# judged CODE PATTERN ARGS...: exit code, and a line of what is said.
judged() {
  local wanted=$1 pattern=$2 code=0
  shift 2
  "$mmverify" prove --quiet "$@" >said 2>&1 || code=$?
  ((code == wanted)) || { cat said; fail "$*: exit code $code, not $wanted"; }
  grep -qE -- "$pattern" said || { cat said; fail "$*: nothing said like: $pattern"; }
}

prover 'echo "proved 10 2 3"'
judged 0 '^proved +tree.round_trip right.c level 1 4-state every map, 4\^4 \(SAT\) [0-9.]+ s$' tree.round_trip --source right.c --levels 0..1 --details
judged 0 '^proved +tree.round_trip right.c levels 0..1, 2-state and 4-state: every map, up to 4\^4 \(SAT\) [0-9.]+ s$' tree.round_trip --source right.c --levels 0..1
judged 0 '^proved +tree.round_trip right.c level 1, 2-state: every map, 2\^4 \(SAT\)' tree.round_trip --source right.c --levels 1 --format 2-state
judged 0 . --source right.c --levels 0..2
(($(wc -l <said) == 6)) || { cat said; fail 'a line a law and the sum'; }
judged 0 '^4 results: 4 proved' tree.round_trip --source right.c --levels 0..1
judged 0 '^1 results: 1 proved' tree.round_trip --source right.c --levels 1 --format 2-state
judged 0 '^proved +tree.canonical' --source right.c --levels 0
judged 2 '^n/a +lossy.allowed right.c: it has no entry' lossy.allowed --source right.c --levels 0
judged 2 '^n/a +micromap.packing right.c and 1 more: it has no entry point micromap_pack' micromap --source right.c --levels 0
judged 2 'lossy.allowed right.c level 0 4-state every map, 4\^1: it has no entry point micromap_substitute' lossy.allowed --source right.c --levels 0 --details
judged 2 'index.nested is proved of no source' index.nested --source right.c
judged 4 'no such file' --source missing.c
cp "$root/examples/subject/subject.c" index.c
judged 2 'index.c: an index function, and no codec: mmverify prove index.floats --source index.c$' --source index.c --levels 0
printf 'int x' >broken.c
judged 2 'broken.c: clang does not compile it' --source broken.c
judged 2 'leave them out' --source right.c --shard 1/2
printf 'BC' >cut.bc
judged 2 '^mmverify: cut.bc: clang does not compile it' --source cut.bc

# A wrong value stands beside the right one: state 1 of the map 1010 is 0.
sed 's/child > 0; --child) skip/child > 1; --child) skip/' "$tree" >skips.c
prover 'case $3 in lookup) echo "refuted tree.c:49: the check fails"; for state in 1 0 1 0; do echo "choice 1 $state"; done; echo "choice 2 1";; *) echo "proved 1 1 1";; esac'
judged 1 '^  case 2-state:1010,index=1: expected 0 got 1 in state\[k\] \(the law.s tree.c:[0-9]+\)$' tree.lookup_is_decode --source skips.c --levels 1 --format 2-state

# A proof counts only if its certificate does.
printf '%s\n' '#!/usr/bin/env bash' 'echo "proved 10 2 3"' >prover
judged 3 'the certificate of the solver is not valid: it was not written' tree.round_trip --source right.c --levels 1 --format 2-state
prover 'while [[ $1 != --certificate ]]; do shift; done; printf "i 1 0\ni 2 0\no 1 2 0\n" >"$2"; echo "proved 10 2 3"'
judged 3 'not valid: line 3: the clause does not follow by unit propagation' tree.round_trip --source right.c --levels 1 --format 2-state

# The folder of certificates and the budget reach the prover.
prover 'echo "$*" >>"$(dirname "$0")/words"; echo "proved 10 2 3"'
mkdir kept
judged 0 . tree.lookup_is_decode --source right.c --levels 1 --format 2-state --budget 7 --certificates kept
grep -qE 'lookup --budget (7|6\.[0-9]+) --certificate kept/tree.lookup_is_decode.level_1.2-state.lookup.2.certificate$' words || { cat words; fail 'the words of the prover'; }

# A second solver: one that agrees, one that has values, one without an answer, and none.
second() { printf '#!/usr/bin/env bash\n[[ $(head -c 5 "$1") == "p cnf" ]] || exit 1\nexit %s\n' "$1" >second; chmod +x second; }
prover 'while [[ $1 != --certificate ]]; do shift; done; printf "i 1 0\ni 2 0\no 1 -1 0\n" >"$2"; echo "proved 10 2 3"'
second 20
judged 0 '^./second agrees: [0-9]+ statements, all of a proof at once; [0-9]+ of [0-9]+ statements, one by one$' tree.round_trip --source right.c --levels 2..3 --format 2-state --second-solver ./second
second 10
judged 3 'second was asked about tree.round_trip.level_1.2-state.round_trip.2.cnf: it finds values' tree.round_trip --source right.c --levels 1 --format 2-state --second-solver ./second
[[ $(head -c 5 tree.round_trip.level_1.2-state.round_trip.2.cnf) == 'p cnf' ]] || fail 'the statement is not kept'
second 7
judged 3 'second was asked about kept/tree.round_trip.level_1.*: it gives no answer \(exit code 7\)' tree.round_trip --source right.c --levels 1 --format 2-state --second-solver ./second --certificates kept
judged 4 'second-solver ./third: there is no program' tree.round_trip --source right.c --levels 1 --format 2-state --second-solver ./third
judged 2 'requires --source' index --second-solver minisat

# A counterexample counts only if a run of the compiled codec fails on it.
prover 'case $3 in round_trip) echo "refuted tree.c:14: a check"; for state in 0 0 0 1; do echo "choice 1 $state"; done;; *) echo "proved 1 1 1";; esac'
judged 3 'case 2-state:0001: by the formula tree.c:14: a check, and the compiled codec keeps the law there' tree.round_trip --source right.c --levels 1 --format 2-state --json right.json
judged 1 '^refuted +tree.round_trip wrong.c level 1, 2-state: ' tree.round_trip --source wrong.c --levels 1 --format 2-state --json wrong.json
grep -qE '^  case 2-state:0001: tree.c:14: a check; tree_decode\(.*\) is false \(the law.s tree.c:[0-9]+\)$' said || { cat said; fail 'the case'; }
again=$(sed -n 's/^  replay: mmverify prove //p' said)
eval "judged 1 '^refuted tree.round_trip level 1 case 2-state:0001 subject wrong.c' $again"
judged 0 '^holds tree.round_trip level 1 case 2-state:0001' tree.round_trip --source right.c --case 1@2-state:0001
judged 2 'it is no case of tree.round_trip at level 1' tree.round_trip --source right.c --case 1@2-state:00012
judged 2 'write LEVEL@CASE' tree.round_trip --source right.c --case 2-state:0001
for result in right wrong; do "$root/scripts/check-schema" $result.json || fail "$result.json"; done
# Nothing but a sanitizer sees these.
sed 's/if (at->nodes >= most) return 0;/if (at->nodes > most) return 0;/' "$tree" >behind.c
judged 1 'AddressSanitizer: .*overflow' tree.malformed --source behind.c --case 0@2-state,code=
sed 's/memset(map, 0, bytes_of(bits, (size_t)1 << 2 \* level));//' "$tree" >unset.c
judged 1 'MemorySanitizer: use-of-uninitialized-value|expected ' tree.round_trip --source unset.c --case 0@2-state:0

# However many laws are refuted, the answer has at most 25 lines, and each law is named.
prover 'echo "refuted tree.c:14: a check"; for state in 0 0 0 1; do echo "choice 1 $state"; done'
judged 3 '^unknown +tree.canonical right.c levels 0..2, 2-state and 4-state: any bytes' --source right.c
(($(wc -l <said) <= 25)) || { cat said; fail "$(wc -l <said) lines"; }

# Past the budget the sample of the law runs.
prover 'echo "progress 5 1 1"; echo "unknown the budget is spent"'
judged 3 '^unknown +tree.round_trip right.c level 2, 2-state and 4-state: ' tree.round_trip --source right.c --levels 2
grep -qE '^checked +tree.on_samples right.c level 2: [0-9,]+ cases, a sample' said || { cat said; fail 'the sample'; }
judged 3 '^checked +tree.on_samples right.c level 2 .* cases' tree.round_trip --source right.c --levels 2 --json unknown.json --details
grep -qE '^unknown +tree.round_trip right.c level 2 2-state' said || { cat said; fail 'unknown'; }
(($(grep -c '^checked' said) == 1)) || fail 'one sample for both formats'
"$root/scripts/check-schema" unknown.json || fail unknown.json
judged 1 '^refuted +tree.on_samples wrong.c level 3' tree.round_trip --source wrong.c --levels 3 --format 2-state
again=$(sed -n 's/^  replay: mmverify prove //p' said | head -1)
eval "judged 1 '^refuted tree.on_samples level 3' $again"

# Code that the prover cannot read, and a prover that fails.
prover 'echo "right.c:12: call: setjmp" >&2; exit 3'
judged 2 '^n/a +tree.round_trip right.c level 1 2-state every map, 2\^4: right.c:12: call: setjmp' tree.round_trip --source right.c --levels 1 --details
judged 2 '^n/a +tree.round_trip right.c: right.c:12: call: setjmp' tree.round_trip --source right.c --levels 1
# One level that cannot be read is no level that is proved.
prover 'if [[ $2 == *law.2.bc ]]; then echo "right.c:12: call: setjmp" >&2; exit 3; fi; echo "proved 1 1 1"'
judged 0 '^n/a +tree.round_trip right.c level 0: right.c:12: call: setjmp' tree.round_trip --source right.c --levels 0..1 --format 2-state
grep -qE '^proved +tree.round_trip right.c level 1, 2-state' said || { cat said; fail 'the level that is proved'; }
prover 'echo "no bitcode" >&2; exit 2'
judged 2 'right.c: mmverify-codec: no bitcode' tree.round_trip --source right.c --levels 1
prover 'kill -SEGV $$'
judged 3 'mmverify-codec: signal 11' tree.round_trip --source right.c --levels 0 --format 2-state
MMVERIFY_CODEC_PROVER=$folder/none judged 4 'there is no program' tree.round_trip --source right.c --levels 0

# Ctrl-C ends the prover and the run within a second.
prover 'echo $$ >"$(dirname "$0")/pid"; exec sleep 60'
rm -f pid
"$mmverify" prove tree.round_trip --quiet --source right.c --levels 1 >said 2>&1 &
run=$!
until [[ -s pid ]]; do sleep 0.05; done
kill -INT $run
start=$(date +%s%N)
code=0
wait $run || code=$?
took=$((($(date +%s%N) - start) / 1000000))
((code == 3)) || { cat said; fail "interrupted: exit code $code"; }
((took < 1500)) || fail "interrupted: $took ms"
! kill -0 "$(<pid)" 2>/dev/null || fail 'the prover runs on'

# The real one.
unset MMVERIFY_CODEC_PROVER
if [[ -x $(dirname "$mmverify")/mmverify-codec ]]; then
  judged 0 '^6 results: 6 proved' tree.round_trip --source right.c --levels 0..2
  judged 1 '^refuted +tree.round_trip wrong.c level 1' tree.round_trip --source wrong.c --levels 1
  if command -v minisat >/dev/null; then
    judged 0 '^minisat agrees: [0-9,]+ statements, all of a proof at once$' tree.round_trip --source right.c --levels 0..2 --second-solver minisat
  fi
  # A prover that merges what simulation cannot tell apart, unproved: its certificate does not follow.
  real=$(readlink -f "$(dirname "$mmverify")/mmverify-codec")
  printf '#!/usr/bin/env bash\nexec %q "$@" --plant unproved-merges\n' "$real" >prover
  sed 's/put(data, bits, at->leaves++, get(map, bits, first));/put(data, bits, at->leaves++, map[0] == 0xb1 \&\& map[1] == 0x4e \&\& map[2] == 0x27 \&\& map[3] == 0xd8 ? 0 : get(map, bits, first));/' right.c >needle.c
  judged 1 'case 4-state:1032230131200213' tree.round_trip --source needle.c --levels 2 --format 4-state
  MMVERIFY_CODEC_PROVER=$folder/prover judged 3 'does not follow by unit propagation' tree.round_trip --source needle.c --levels 2 --format 4-state
else
  echo 'no mmverify-codec in this build: its part is left out'
fi

((failures == 0)) || { printf '%d failures\n' "$failures"; exit 1; }
echo ok
