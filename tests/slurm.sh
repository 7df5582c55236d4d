#!/usr/bin/env bash
# A sweep as a job array on a real Slurm: split over two tasks, one of them killed and started again,
# merged: the tables of an undisturbed sweep, to the byte.
#
#   tests/slurm.sh [TRIBOS]    the program; target/debug/tribos if left out
#
# Uses the Slurm that answers, else starts one of a single node for the time of the test (as root, with
# slurmctld, slurmd and munged from the packages slurm-wlm and munge). Says "skipped" where neither can be.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
tribos=$(realpath "${1:-${CARGO_TARGET_DIR:-$here/target}/debug/tribos}")
work=$(mktemp -d "${TMPDIR:-/tmp}/tribos-slurm.XXXXXX")
chmod 755 "$work"
daemons=()

finish() {
  status=$?
  if [ $status != 0 ]; then
    echo "FAILED; logs:" >&2
    tail -n 20 "$work"/*.log "$work"/array/logs/*.log >&2 || true
  fi
  # Last started, first stopped.
  for ((i = ${#daemons[@]} - 1; i >= 0; i--)); do kill "${daemons[i]}" 2>/dev/null || true; done
  wait || true
  rm -rf "$work"
  exit $status
}
trap finish EXIT

skip() { echo "skipped: no Slurm: $1"; exit 0; }

# The command succeeds within so many seconds.
within() {
  local seconds=$1
  shift
  for ((i = 0; i < 5 * seconds; i++)); do
    if "$@" >/dev/null 2>&1; then return 0; fi
    sleep 0.2
  done
  return 1
}

answers() { timeout 5 sinfo --noheader 2>/dev/null | grep -Eq 'idle|mix|alloc'; }

start_slurm() {
  [ "$(id -u)" = 0 ] || skip "none answers, and starting one needs root"
  local program
  for program in munged slurmctld slurmd sbatch scontrol; do
    command -v $program >/dev/null || skip "none answers, and $program is not installed (slurm-wlm, munge)"
  done
  local host cores
  host=$(hostname -s)
  cores=$(nproc)
  mkdir -p "$work"/{munge,state,spool}
  head -c 1024 /dev/urandom >"$work/munge/key"
  chmod 700 "$work/munge"
  chmod 600 "$work/munge/key"
  munged --foreground --force --key-file="$work/munge/key" --socket="$work/munge.socket" \
    --pid-file="$work/munge/pid" --seed-file="$work/munge/seed" --log-file="$work/munge.log" \
    >"$work/munged.log" 2>&1 &
  daemons+=($!)
  cat >"$work/slurm.conf" <<CONF
ClusterName=tribos
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
CredType=cred/munge
SlurmUser=root
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerParameters=sched_interval=1,batch_sched_delay=0
KillWait=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$cores State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=60 State=UP
CONF
  export SLURM_CONF="$work/slurm.conf"
  within 10 test -S "$work/munge.socket" || skip "munged does not start: $(tail -n 3 "$work"/munge*.log)"
  slurmctld -D >"$work/slurmctld.out.log" 2>&1 &
  daemons+=($!)
  slurmd -D -N "$host" >"$work/slurmd.out.log" 2>&1 &
  daemons+=($!)
  within 30 answers || skip "the daemons do not start: $(tail -n 5 "$work"/slurm*.log)"
}

if command -v sinfo >/dev/null && answers; then
  echo "using the Slurm that answers"
else
  start_slurm
  echo "started $(sbatch --version) on $(hostname -s)"
fi

# Some tens of spheres; 25 runs of less than a second.
cd "$work"
cat >scene.toml <<'SCENE'
body = "powder"
width = 12
height = 25
pressure = 0.01
piston_mass = 100
steps = 1500
SCENE
keys=(--set mu_rolling=0,0.1,0.2,0.3,0.4 --set mu_torsion=0,0.1,0.2,0.3,0.4)
"$tribos" sweep scene.toml "${keys[@]}" --out whole 2>whole.log >/dev/null

"$tribos" sweep scene.toml "${keys[@]}" --out array --slurm --slurm-tasks 2 --slurm-option=--time=5
# An edit of the scene does not reach the array.
sed -i 's/0.01/0.02/' scene.toml
job=$(sbatch --parsable array/job.sh)
echo "array $job submitted"

ended() { find array/runs -name summary.json 2>/dev/null | wc -l; }
some_ended() { [ "$(ended)" -ge 2 ]; }
within 60 some_ended
scancel "${job}_0"
echo "task 0 killed after $(ended) of 25 runs"
gone() { [ -z "$(squeue --noheader --job "$job" 2>/dev/null)" ]; }
within 120 gone

job=$(sbatch --parsable --array=0 array/job.sh)
within 120 gone
grep 'runs kept' array/logs/0.log || { echo "task 0 did not go on" >&2; exit 1; }

"$tribos" sweep --merge array >/dev/null
for table in sweep.csv runs.csv sweep.parquet runs.parquet sweep.svg; do
  if [ -e "whole/$table" ]; then cmp "whole/$table" "array/$table"; fi
done
echo "25 runs in two tasks, one of them killed: the undisturbed tables to the byte"
