#!/usr/bin/env bash
# programs.sh -- on a machine with a GPU: random programs of calls on it beside the CPU, in each form of its work.
#
# usage: bench/programs.sh [DEVICE [FOLDER]]
#   DEVICE  part of the name of an OpenCL device, as in --device opencl:DEVICE; default NVIDIA
#   FOLDER  where programs.txt goes, and programs that fail, made shorter; default bench/results/DEVICE
# PROGRAMS (1000) run in each form, for SECONDS_EACH (120) at most. Exit 1 when any leaves other bits than on the CPU.
# build/tests/programs is built already.
set -euo pipefail
cd "$(dirname "$0")/.."
device=${1:-NVIDIA}
folder=${2:-bench/results/$(echo "$device" | tr 'A-Z ' 'a-z-')}
programs=${PROGRAMS:-1000}
mkdir -p "$folder/programs"

# each GPU takes its share, for processes take turns on one
gpus=$(nvidia-smi -L 2>/dev/null | grep -c ^GPU || true)
[ "${gpus:-0}" -gt 0 ] || gpus=1

# usual, launches alone, tiles: the environment chooses
for form in SCREE_SOLVER= SCREE_PERSISTENT=0 SCREE_SOLVER=tiles; do
	# built once, for the others to find
	env "$form" build/tests/programs --device "opencl:$device" --programs 1 >/dev/null || true
	for ((gpu = 0; gpu < gpus; ++gpu)); do
		env "$form" CUDA_VISIBLE_DEVICES=$gpu build/tests/programs --device "opencl:$device" --seed $((gpu * programs)) \
			--programs $(((programs + gpus - 1) / gpus)) --jobs 2 --life 64 --every 5 --seconds "${SECONDS_EACH:-120}" \
			--out "$folder/programs" | sed "s/^opencl:/$form &/" &
	done
	wait
done | tee "$folder/programs.txt"
rmdir "$folder/programs" 2>/dev/null || true
[ "$(grep -c ' 0 failures' "$folder/programs.txt")" = $((3 * gpus)) ]
