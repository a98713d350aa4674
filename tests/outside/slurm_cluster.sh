# shellcheck shell=bash
# A whole Slurm cluster of this one machine, in one folder: munge, the controller and a node daemon, with their own
# configuration, key, socket and ports. Runs as root or as anybody; needs no cgroups and no systemd. To be sourced.

# processes FILE TEXT: the ids of the processes whose /proc/ID/FILE (cmdline, environ) holds TEXT; never this grep's own.
processes() {
  grep -lzF -- "$2" /proc/[0-9]*/"$1" 2>/dev/null | while IFS=/ read -r _ _ id _; do
    [[ ! -d /proc/$id ]] || printf '%s\n' "$id"
  done
}

# Two TCP ports that nobody listens on.
free_ports() {
  local found=0 port
  while ((found < 2)); do
    port=$((20000 + RANDOM % 40000))
    if ! (: </dev/tcp/127.0.0.1/"$port") 2>/dev/null; then
      printf '%s\n' "$port"
      found=$((found + 1))
    fi
  done
}

slurm_conf() {
  local folder=$1 host=$2 controller_port=$3 node_port=$4 user
  user=$(id -un)
  # cred_expire is also how long a task that was queued again waits: 120 s by default, 5 at least.
  # config_overrides: two processors, whatever the machine has.
  cat <<TEXT
ClusterName=mmverify-test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$controller_port
SlurmdPort=$node_port
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket,cred_expire=5
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,bf_interval=1
KillWait=5
MpiDefault=none
SlurmdParameters=config_overrides
NodeName=$host NodeAddr=127.0.0.1 CPUs=2
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE
TEXT
}

# start_cluster FOLDER: sets SLURM_CONF; fails where the node is not idle within 30 s, the daemons' words in FOLDER/*.out.
start_cluster() {
  local folder=$1 host try end=$((SECONDS + 30))
  local -a ports
  host=$(uname -n)
  host=${host%%.*}
  mapfile -t ports < <(free_ports)
  chmod 755 "$folder"  # munge wants its socket within everybody's reach
  mkdir "$folder"/{munge,state,spool}
  (umask 077 && head -c 128 /dev/urandom >"$folder/munge/key")
  slurm_conf "$folder" "$host" "${ports[@]}" >"$folder/slurm.conf"
  # Where this runs inside a job of a real cluster, that one's words must not reach ours.
  unset "${!SLURM_@}" "${!SBATCH_@}"
  export SLURM_CONF=$folder/slurm.conf

  munged --foreground --key-file="$folder/munge/key" --socket="$folder/munge/socket" --pid-file="$folder/munge/pid" \
    --log-file="$folder/munge/log" --seed-file="$folder/munge/seed" >"$folder/munged.out" 2>&1 &
  for ((try = 0; try < 50; try++)); do
    [[ ! -S $folder/munge/socket ]] || break
    sleep 0.1
  done
  [[ -S $folder/munge/socket ]] || return 1
  slurmctld -D >"$folder/slurmctld.out" 2>&1 &
  (cd "$folder/spool" && exec slurmd -D) >"$folder/slurmd.out" 2>&1 &
  while ((SECONDS < end)); do
    [[ $(timeout 3 sinfo --noheader --format=%t 2>/dev/null) != idle ]] || return 0
    sleep 0.2
  done
  return 1
}

# What the cluster has started: all have its configuration in their environment, but Slurm's step managers write over
# theirs; these are where the node daemon is.
started() {
  processes environ "$1/slurm.conf"
  find /proc/[0-9]*/cwd -maxdepth 0 -lname "$1/*" 2>/dev/null | cut -d/ -f3
}

# stop_cluster FOLDER: ends the daemons, then what is left of their jobs, and removes the folder.
stop_cluster() {
  local folder=$1 daemons rest try
  unset SLURM_CONF
  mapfile -t daemons < <(jobs -p)
  ((${#daemons[@]} == 0)) || kill -TERM "${daemons[@]}" 2>/dev/null || true
  for ((try = 0; try < 30; try++)); do
    [[ -n $(jobs -pr) ]] || break
    sleep 0.1
  done
  while mapfile -t rest < <(started "$folder") && ((${#rest[@]})); do
    kill -KILL "${rest[@]}" 2>/dev/null || true
    sleep 0.1
  done
  wait 2>/dev/null || true
  rm -rf -- "$folder"
}
