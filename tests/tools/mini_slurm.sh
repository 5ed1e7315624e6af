#!/usr/bin/env bash
# A Slurm cluster of two nodes on one machine, for batch_slurm_test. As root; on the loopback
# interface only; without systemd and cgroups.
#
#   mini_slurm.sh start DIR PORT OWNER   # takes PORT to PORT + 2; ends once process OWNER has
#   mini_slurm.sh lose DIR NODE          # kills a node, node1 or node2, with all of its jobs
#   mini_slurm.sh stop DIR
#
# DIR must be short, as paths of sockets are. SLURM_CONF=DIR/slurm.conf leads sbatch and the like
# here. Each node has a disk of its own, DIR/disk/NODE, to which TMPDIR points in its jobs.
set -euo pipefail
PATH=$PATH:/usr/sbin:/sbin
command=$1 dir=$2
export SLURM_CONF=$dir/slurm.conf

# start_daemon NAME PROGRAM ARGUMENTS...: notes its process id. Out of the group of the caller,
# which may be killed as a whole.
start_daemon() {
  local name=$1
  shift
  setsid "$@" > "$dir/log/$name.out" 2>&1 < /dev/null &
  echo $! > "$dir/pid/$name"
}

start_node() { start_daemon "$1" slurmd -D -N "$1" -f "$SLURM_CONF"; }

wait_until() {
  for ((tenth = 0; tenth < 200; ++tenth)); do
    if "$@" > /dev/null 2>&1; then return 0; fi
    sleep 0.1
  done
  echo "mini_slurm.sh: waited in vain for: $*" >&2
  tail -n 5 "$dir"/log/* >&2
  return 1
}

both_idle() { [[ $(sinfo -h -N -t idle -o %N | sort -u | wc -l) == 2 ]]; }

# The process that runs a job is no child of slurmd and hides its environment. The node's log, which
# it holds open, tells whose it is.
steps_of() {
  local pid
  for pid in $(pgrep -x slurmstepd); do
    if grep -qxF "$dir/log/$1.log" <<< "$(readlink "/proc/$pid"/fd/* 2> /dev/null)"; then
      echo "$pid"
    fi
  done
}

# Parents first: none of them may live to tell of its child's end.
with_children() {
  local child
  echo "$1"
  for child in $(pgrep -P "$1"); do with_children "$child"; done
}

is_dead() { ! grep -q '^State:.[^Z]' "/proc/$1/status"; }

kill_steps_of() {
  local step pid pids=()
  for step in $(steps_of "$1"); do mapfile -t -O "${#pids[@]}" pids < <(with_children "$step"); done
  for pid in "${pids[@]}"; do kill -9 "$pid" 2> /dev/null || true; done
  for pid in "${pids[@]}"; do wait_until is_dead "$pid"; done
}

kill_daemon() {
  local pid
  pid=$(cat "$dir/pid/$1" 2> /dev/null) || return 0
  kill -9 "$pid" 2> /dev/null || true
  rm -f "$dir/pid/$1"
}

lose_node() {
  kill_daemon "$1"
  kill_steps_of "$1"
}

stop() {
  lose_node node1
  lose_node node2
  kill_daemon slurmctld
  kill_daemon munged
  rm -rf "$dir/pid"
}

case $command in
  start)
    port=$3 owner=$4
    host=$(hostname -s)
    mkdir -p "$dir"/{log,pid,state,spool/node1,spool/node2,disk/node1,disk/node2}
    chmod 755 "$dir"
    (umask 077 && head -c 1024 /dev/urandom > "$dir/munge.key")
    cat > "$dir/task_prolog.sh" << PROLOG
#!/bin/sh
echo "export TMPDIR=$dir/disk/\$SLURMD_NODENAME"
PROLOG
    chmod 755 "$dir/task_prolog.sh"
    cat > "$SLURM_CONF" << CONF
ClusterName=mini
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmUser=root
SlurmdUser=root
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
AuthType=auth/munge
AuthInfo=socket=$dir/munge.socket
CredType=cred/munge
StateSaveLocation=$dir/state
SlurmdSpoolDir=$dir/spool/%n
SlurmctldPidFile=$dir/pid/slurmctld.own
SlurmdPidFile=$dir/pid/%n.own
SlurmctldLogFile=$dir/log/slurmctld.log
SlurmdLogFile=$dir/log/%n.log
TaskProlog=$dir/task_prolog.sh
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
LaunchParameters=disable_send_gids
ReturnToService=2
SlurmdTimeout=10
SlurmctldTimeout=10
InactiveLimit=0
KillWait=2
MinJobAge=900
MessageTimeout=5
SchedulerType=sched/backfill
SchedulerParameters=bf_interval=1,sched_interval=1,sched_min_interval=100000,batch_sched_delay=0
NodeName=node1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=2 RealMemory=100000
NodeName=node2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=2 RealMemory=100000
PartitionName=main Nodes=node1,node2 Default=YES MaxTime=INFINITE State=UP
CONF
    start_daemon munged munged --foreground --force --num-threads=2 --key-file="$dir/munge.key" \
      --socket="$dir/munge.socket" --pid-file="$dir/pid/munged.own" \
      --log-file="$dir/log/munged.log" --seed-file="$dir/munge.seed"
    # Whoever owns it may be killed before it stops it.
    setsid bash -c 'while kill -0 "$1" && [ -e "$3/pid" ]; do sleep 1; done; "$2" stop "$3"' - \
      "$owner" "$(realpath "$0")" "$dir" > /dev/null 2>&1 < /dev/null &
    wait_until munge -n -S "$dir/munge.socket"
    start_daemon slurmctld slurmctld -D -c -f "$SLURM_CONF"
    start_node node1
    start_node node2
    wait_until both_idle
    ;;
  lose) lose_node "$3" ;;
  stop) stop ;;
  *)
    sed -n '2,10p' "$0" >&2
    exit 1
    ;;
esac
