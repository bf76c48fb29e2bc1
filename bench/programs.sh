#!/usr/bin/env bash
# programs.sh -- runs random sequences of API calls on CPU and GPU, with three forms of the solve, and compares the bits.
#
# usage: bench/programs.sh [DEVICE [FOLDER]]
#   DEVICE  part of the name of an OpenCL device or of its driver, as in --device opencl:DEVICE; default NVIDIA
#   FOLDER  gets programs.txt, and a shortened copy of each program that fails; default bench/results/DEVICE
# Each form runs PROGRAMS (1000) programs, for at most SECONDS_EACH (120) seconds. Exit 1 when bits differ from those of the
# CPU. build/tests/programs must have been built.
set -euo pipefail
. "$(dirname "$0")/../tools/usage.sh"
cd "$(dirname "$0")/.."
device=${1:-NVIDIA}
folder=${2:-bench/results/$(echo "$device" | tr 'A-Z ' 'a-z-')}
programs=${PROGRAMS:-1000}
mkdir -p "$folder/programs"

# the programs are distributed over all GPUs, because processes on one GPU run in turns
gpus=$(nvidia-smi -L 2>/dev/null | grep -c ^GPU || true)
[ "${gpus:-0}" -gt 0 ] || gpus=1

for form in default launches tiles; do
	# builds the kernels once, so that the other processes find them in the cache
	build/tests/programs --device "opencl:$device" --form $form --programs 1 >/dev/null || true
	for ((gpu = 0; gpu < gpus; ++gpu)); do
		CUDA_VISIBLE_DEVICES=$gpu build/tests/programs --device "opencl:$device" --form $form --seed $((gpu * programs)) \
			--programs $(((programs + gpus - 1) / gpus)) --jobs 2 --life 64 --every 5 --seconds "${SECONDS_EACH:-120}" \
			--out "$folder/programs" | sed "s/^opencl:/$form &/" &
	done
	wait
done | tee "$folder/programs.txt"
rmdir "$folder/programs" 2>/dev/null || true
[ "$(grep -c ' 0 failures' "$folder/programs.txt")" = $((3 * gpus)) ]
