#!/usr/bin/env bash
# gpu.sh -- tests and measures a GPU: builds, compares hashes of all scenes and of random programs on CPU and GPU, then measures.
#
# usage: bench/gpu.sh [DEVICE [FOLDER]]
#   DEVICE  part of the name of an OpenCL device or of its driver, as in --device opencl:DEVICE; default NVIDIA
#   FOLDER  gets parity.csv, programs.txt, bench.csv, queries.csv, rays.csv, frames.csv, sleep.csv, machine.txt and the curves;
#           default bench/results/DEVICE
# Variables and their defaults:
#   STEPS (300)      number of steps after which hashes are compared
#   HEAVY (million)  scenes that the CPU simulates with one thread for only HEAVY_STEPS (10) steps
#   PROGRAMS, SECONDS_EACH  passed to bench/programs.sh; PROGRAMS=0 skips that script
#   BENCH            scenes to measure
#   FRAMES           scenes to draw
#   QUERIES          scene for a million queries
#   RAYS             scene whose rays are cast after every step
#   SLEEP            cases of scree_sleep, measured on the GPU and, except ball, on two threads and on all threads of the CPU
#   SLEEP_OPTIONS    further options of scree_sleep, for example --sleepers 99000
#   CURVES=yes       also runs bench/curves.sh
#   LIMIT (240)      maximum seconds of a run
#   FIGURES=yes      draws the figures of docs/measurements/paper.md
# BENCH, FRAMES, QUERIES, RAYS or SLEEP with the value none skips its part. Exit 1 when a hash or a picture differs or a row is
# invalid.
set -euo pipefail
. "$(dirname "$0")/../tools/usage.sh"
cd "$(dirname "$0")/.."
device=${1:-NVIDIA}
folder=${2:-bench/results/$(echo "$device" | tr 'A-Z ' 'a-z-')}
steps=${STEPS:-300}
heavy=" ${HEAVY:-million} "
heavy_steps=${HEAVY_STEPS:-10}
limit=${LIMIT:-240} # maximum seconds of a run, so that a kernel that hangs does not block the machine
mkdir -p "$folder"

cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release >build.log 2>&1 && ninja -C build >>build.log 2>&1 ||
	{ tail -n 30 build.log; exit 1; }
rm -f build.log
scree=build/scree
{
	echo "commit: ${COMMIT:-$(git describe --always --dirty 2>/dev/null || echo unknown)}"
	echo "processor: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores"
	command -v nvidia-smi >/dev/null && nvidia-smi --query-gpu=name,driver_version,memory.total --format=csv,noheader
	$scree devices
} >"$folder/machine.txt"
cat "$folder/machine.txt"

lanes=8
grep -q avx512vl /proc/cpuinfo && lanes=16
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export SCREE_CACHE=$work/cache # an empty cache, so that programs are built again
# keep NAME SCENE COMMAND...: writes the hash that COMMAND prints, or its error message, to $work/SCENE.NAME
keep()
{
	local file=$work/$2.$1
	timeout "$limit" "${@:3}" >"$file" 2>"$file.err" || echo "failed:$(tr '\n,' '  ' <"$file.err" | cut -c 1-120)" >"$file"
}
# hash_of NAME SCENE STEPS OPTION...: writes the hash of a scene after this number of steps to $work/SCENE.NAME
hash_of() { keep "$1" "$2" $scree hash "$2" --steps "${@:3}"; }
export -f keep hash_of
export work scree limit

# computes the reference hashes on the CPU in several processes, while the GPU runs the scenes
jobs=$work/jobs
for scene in $($scree scenes --names); do
	count=$steps
	case $heavy in *" $scene "*) count=$heavy_steps ;; esac
	echo "hash_of one $scene $count --device cpu --threads 1 --lanes 1"
	echo "hash_of two $scene $count --device cpu --threads 2 --lanes 8"
	echo "hash_of wide $scene $count --device cpu --threads 2 --lanes $lanes"
done >"$jobs"
xargs -P $(($(nproc) / 2 + 1)) -I{} bash -c '{}' <"$jobs" &
references=$!
for scene in $($scree scenes --names); do
	count=$steps
	case $heavy in *" $scene "*)
		count=$heavy_steps
		# heavy scenes are also compared after all steps, on all cores of the CPU
		hash_of "long" "$scene" "$steps" --device "opencl:$device"
		;;
	esac
	hash_of gpu "$scene" "$count" --device "opencl:$device"
	keep launches "$scene" build/tests/scene_hash "$scene" "$count" "opencl:$device" launches
done
wait $references

# NVIDIA's driver returns programs as PTX, a text in which .func begins a function that is not inlined. Such a function is slow,
# because every work-item then keeps its pool pointers on the stack.
calls=$(cat "$SCREE_CACHE"/* | grep -a '^\.func' | sort -u || true)
echo "functions that are not inlined: ${calls:-none}" | tee -a "$folder/machine.txt"

echo "scene,steps,cpu_1_thread_1_lane,cpu_2_threads_8_lanes,cpu_2_threads_${lanes}_lanes,gpu,gpu_launches_only,equal" >"$folder/parity.csv"
differ=0
for scene in $($scree scenes --names); do
	count=$steps
	case $heavy in *" $scene "*) count=$heavy_steps ;; esac
	row=$scene,$count
	equal=yes
	for name in one two wide gpu launches; do
		row=$row,$(cat "$work/$scene.$name")
		cmp -s "$work/$scene.one" "$work/$scene.$name" || equal=no
	done
	grep -q failed "$work/$scene.one" && equal=no
	[ $equal = yes ] || differ=1
	echo "$row,$equal" >>"$folder/parity.csv"
done
for scene in $heavy; do
	hash_of all "$scene" "$steps" --device cpu
	equal=yes
	cmp -s "$work/$scene.all" "$work/$scene.long" || { equal=no; differ=1; }
	echo "$scene,$steps,,,$(cat "$work/$scene.all"),$(cat "$work/$scene.long"),,$equal" >>"$folder/parity.csv"
done
cat "$folder/parity.csv"

[ "${PROGRAMS:-1000}" = 0 ] || bench/programs.sh "$device" "$folder" || differ=1

scenes=${BENCH:-million pyramids pyramid pile tumbler smash washer storm churn}
if [ "$scenes" != none ]; then
	timeout 500 $scree bench $scenes --device "opencl:$device" --steps "$steps" | tee "$folder/bench.csv" || differ=1
fi
queries=${QUERIES:-million}
if [ "$queries" != none ]; then
	for where in "opencl:$device" cpu; do
		timeout "$limit" $scree bench queries "$queries" --steps 60 --device "$where" || differ=1
	done | awk 'NR == 1 || !/^scene,/' | tee "$folder/queries.csv"
	# the results on CPU and GPU must be equal
	answers=$(sed 1d "$folder/queries.csv" | awk -F, '{ print $4, $NF }' | sort | uniq -c | grep -c '^ *2 ')
	[ "$answers" = 5 ] || { echo "queries.csv: results differ, or are missing"; differ=1; }
fi
rays=${RAYS:-lidar}
if [ "$rays" != none ]; then
	for where in "opencl:$device" cpu; do
		timeout "$limit" $scree bench "$rays" --steps 60 --device "$where" || differ=1
	done | awk 'NR == 1 || !/^scene,/' | tee "$folder/rays.csv"
	# hash_rays, penetration and hash are the three columns before the last one
	hashes=$(sed 1d "$folder/rays.csv" | rev | cut -d, -f 2-4 | sort | uniq -c | grep -c '^ *2 ')
	[ "$hashes" = 1 ] || { echo "rays.csv: results differ, or are missing"; differ=1; }
fi
frames=${FRAMES:-million pile pyramids tumbler}
if [ "$frames" != none ]; then
	for scene in $frames; do
		for where in "opencl:$device" cpu; do
			timeout "$limit" $scree bench frames "$scene" --device "$where" --steps 150
		done
	done | awk 'NR == 1 || !/^scene,/' | tee "$folder/frames.csv" || differ=1
	# each scene has four runs, with shared and with copied rows, on the CPU and on the GPU: all must have the same picture and hash
	pictures=$(sed 1d "$folder/frames.csv" | cut -d, -f 1,11,12 | sort | uniq -c | grep -c '^ *4 ')
	[ "$pictures" = "$(echo $frames | wc -w)" ] || { echo "frames.csv: pictures differ, or are missing"; differ=1; }
fi
cases=${SLEEP:-part balls ball all awake spawn ray sensor wake-created wake-hit wake-body wake-world}
if [ "$cases" != none ]; then
	for case in $cases; do
		for threads in gpu 2 all; do
			where=(--device cpu)
			case $threads in
			gpu) where=(--device "opencl:$device") ;;
			2) where+=(--threads 2) ;;
			esac
			[ "$case $threads" = "ball 2" ] || [ "$case $threads" = "ball all" ] && continue
			# shellcheck disable=SC2086
			timeout "$limit" ${scree}_sleep --csv --case "$case" "${where[@]}" ${SLEEP_OPTIONS:-} ||
				echo "$case,failed on ${where[*]},0"
		done
	done | awk '!/^case,/ || !headings++' | tee "$folder/sleep.csv"
	# each row must be valid, and all rows of a world must have the same hash
	awk -F, '
		$1 == "case" { next }
		$NF != 1 { print "sleep.csv: not valid: " $0; bad = 1; next }
		($1, $2) in hash && hash[$1, $2] != $(NF - 1) { print "sleep.csv: hashes of " $1 " differ"; bad = 1 }
		{ hash[$1, $2] = $(NF - 1); ++rows }
		END { exit bad || !rows }' "$folder/sleep.csv" || differ=1
fi
if [ "${CURVES:-no}" = yes ]; then
	bench/curves.sh "$folder" "opencl:$device" || differ=1
fi
if [ "${FIGURES:-no}" = yes ]; then
	for figure in figure5 figure6; do
		(cd "$folder" && timeout 300 "$OLDPWD/${scree}_paper" $figure --device "opencl:$device") || differ=1
	done
fi
exit $differ
