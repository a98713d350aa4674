#!/usr/bin/env bash
# A run on a real Slurm cluster of this one machine: a task killed in the middle, one stopped in good time, the merge,
# a missing shard, a refuted law.
# usage: tests/outside/slurm_test.sh MMVERIFY [LEVEL]        exit code 77: skipped, and why
set -euo pipefail

(($# == 1 || $# == 2)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
MMVERIFY=$(realpath -- "$1")
export MMVERIFY
level=${2:-15} shards=7
tests=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
slurm=$tests/../../scripts/slurm
# shellcheck source=tests/outside/slurm_cluster.sh
source "$tests/slurm_cluster.sh"

say() { printf '%3d s  %s\n' "$SECONDS" "$*"; }
skip() { printf 'skipped: %s\n' "$*"; exit 77; }
fail() {
  printf 'FAILED: %s\n' "$*"
  tail -n 30 "$folder"/run/*.log 2>/dev/null || true
  exit 1
}

for program in munged slurmctld slurmd sbatch python3; do
  PATH=$PATH:/usr/sbin:/sbin
  command -v "$program" >/dev/null || skip "no $program here; ./run cluster-test installs it"
done

folder=$(mktemp -d)
trap 'stop_cluster "$folder"' EXIT
trap 'exit 1' HUP INT TERM
if ! start_cluster "$folder"; then
  tail -n 5 "$folder"/*.out
  skip "Slurm's daemons do not start here; their words are above"
fi
say "$(sbatch --version) is up, as $(id -un), 2 processors"

# state JOB: JobState and ExitCode, once a job is one of a kind: COMPLETED 0:0
state() { scontrol show job "$1" | sed -nE 's/.*JobState=([A-Z_]+).*/\1/p; s/.*ExitCode=([0-9:]+).*/\1/p' | paste -sd' '; }

# await JOB: until it is over; prints its state.
await() {
  local now
  while now=$(state "$1"); [[ $now == PENDING* || $now == CONFIGURING* || $now == RUNNING* || $now == COMPLETING* ]]; do
    ((SECONDS < 240)) || fail "job $1 is still $now"
    sleep 0.2
  done
  printf '%s\n' "$now"
}

job_of() { sed -n "s/^$1: job \([0-9]*\).*/\1/p" "$folder/submitted"; }
size() { stat -c %s -- "$1" 2>/dev/null || echo 0; }

# A prover at work, its journal growing, of a shard other than OTHER: sets pid and shard.
catch() {
  local other=$1 before
  while [[ $(state "$merge") == PENDING* ]]; do
    for pid in $(processes cmdline "$folder/run/shard-"); do
      [[ $(readlink "/proc/$pid/exe") == "$MMVERIFY" ]] || continue
      shard=$(tr '\0' '\n' 2>/dev/null <"/proc/$pid/cmdline" | sed -n 's/.*\/shard-\([0-9]*\)\.journal$/\1/p') || continue
      [[ -n $shard && $shard != "$other" ]] || continue
      before=$(size "$folder/run/shard-$shard.journal")
      sleep 0.05
      ((before == 0 || $(size "$folder/run/shard-$shard.journal") <= before)) || return 0
    done
  done
  fail "no prover was caught at work: level $level is too quick"
}

# strike OTHER COMMAND...: COMMAND with the process of a prover, until one of its shards was queued again; sets shard.
strike() {
  local other=$1 log
  shift
  while :; do
    catch "$other"
    "$@" "$pid" || continue
    log=$folder/run/shard-$shard.log
    # Slurm may end the script before it says so; then the next start does.
    until grep -qsE 'queued again|DUE TO JOB REQUEUE|restart [1-9]' "$log"; do
      [[ $(state "${array}_$shard") != COMPLETED* ]] || continue 2  # it was done before the signal came
      ((SECONDS < 240)) || fail "shard $shard was not queued again"
      sleep 0.05
    done
    return
  done
}
# As Slurm does a minute before the time limit: USR1 to the task's script, the prover's parent.
near_time_limit() { kill -USR1 "$(sed 's/.*) //' "/proc/$1/stat" | cut -d' ' -f2)"; }

# What must not depend on how the work was cut.
verdicts() {
  python3 -c '
import json, sys
for r in json.load(open(sys.argv[1]))["results"]:
    print(*(r[k] for k in ("law", "subject", "level", "verdict", "cases_expected", "cases_run", "mismatches", "digest")))
' "$1"
}

law=(index.equals_reference --subject step --levels "$level")
"$slurm/submit" "$shards" "$folder/run" -- "${law[@]}" >"$folder/submitted"
array=$(job_of shards) merge=$(job_of merge)
say "submitted: array $array, merge $merge"

strike none kill -KILL
killed=$shard
say "killed the prover of shard $killed, its journal at $(size "$folder/run/shard-$killed.journal") bytes"
strike "$killed" near_time_limit
stopped=$shard
say "stopped shard $stopped in good time, its journal at $(size "$folder/run/shard-$stopped.journal") bytes"

"$MMVERIFY" prove "${law[@]}" --threads 1 --quiet --json "$folder/whole.json" >/dev/null
say "the whole on one thread: $(verdicts "$folder/whole.json")"

ended=$(await "$merge")
[[ $ended == "COMPLETED 0:0" ]] || fail "the merge ended $ended: $(cat "$folder/run/merge.log")"
say "merged:                  $(verdicts "$folder/run/merged.json")"
diff <(verdicts "$folder/whole.json") <(verdicts "$folder/run/merged.json") || fail "the merged result is another"
for k in "$killed" "$stopped"; do
  grep -qE "restart 1: journal of [1-9]" "$folder/run/shard-$k.log" || fail "shard $k did not go on from its journal"
done
say "shards $killed and $stopped were queued again and went on from their journals"

# merge_job NAME: the merge alone, its words in NAME.log; prints its state.
merge_job() {
  local job
  job=$(sbatch --parsable --output="$folder/run/$1.log" "$slurm/merge.sbatch" "$folder/run" "$shards" "$MMVERIFY")
  await "$job"
}
mv "$folder/run/shard-4.json" "$folder/shard-4.json"
ended=$(merge_job missing)
[[ $ended == "FAILED 4:0" ]] || fail "the merge without shard 4 ended $ended"
grep -q 'no result of shard 4' "$folder/run/missing.log" || fail "the merge does not name shard 4"
cp "$folder/run/shard-5.json" "$folder/run/shard-4.json"
ended=$(merge_job twice)
[[ $ended == "FAILED 4:0" ]] || fail "the merge with shard 5 in the place of shard 4 ended $ended"
say "without shard 4, and with shard 5 twice, the merge fails"

rm "$folder/run/shard-4.json"
"$slurm/submit" "$shards" "$folder/run" -- "${law[@]}" >"$folder/submitted"
ended=$(await "$(job_of merge)")
[[ $ended == "COMPLETED 0:0" ]] || fail "the merge of a second submission ended $ended: $(cat "$folder/run/merge.log")"
diff <(verdicts "$folder/whole.json") <(verdicts "$folder/run/merged.json") || fail "a second submission's result is another"
say "submitted again, from complete journals: the same"

refusal() { local code=0; "$slurm/submit" "$@" >"$folder/refusal" 2>&1 || code=$?; printf '%s\n' "$code"; }
[[ $(refusal 7 "$folder/run" -- index.in_range) == 4 ]] || fail "a folder of another run is taken"
[[ $(refusal 7 "$folder/munge" -- index.in_range) == 4 ]] || fail "a folder that is in use is taken"
[[ $(refusal 0 "$folder/none" -- index.in_range) == 2 ]] || fail "no shards are taken"
[[ $(refusal 7 "$folder/none" -- index.in_range --json x) == 2 ]] || fail "--json is taken"

"$slurm/submit" 2 "$folder/run of a wrong one" -- index.equals_reference --subject step-appendix-ties --levels 5 \
  >"$folder/submitted"
ended=$(await "$(job_of merge)")
[[ $ended == "FAILED 1:0" ]] || fail "the merge of a refuted law ended $ended"
say "a refuted law: the merge ends $ended"

"$slurm/submit" 2 "$folder/cancelled" -- "${law[@]}" >"$folder/submitted"
until (($(size "$folder/cancelled/shard-1.journal"))); do
  ((SECONDS < 240)) || fail "the task to be cancelled does not start"
  sleep 0.1
done
scancel "$(job_of shards)_1"
ended=$(await "$(job_of shards)_1")
[[ $ended == CANCELLED* ]] || fail "a cancelled task ended $ended"
! grep "queued again" "$folder/cancelled/shard-1.log" || fail "a cancelled task was queued again"
say "a cancelled task stays so"
say "ok"
