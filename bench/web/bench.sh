#!/usr/bin/env bash
# bench.sh -- measures steps of Scree and of other npm engines with node, and writes bench/results/web/steps.csv.
#
# usage: bench/web/bench.sh [ENGINE...]
#   ENGINE  scree, scree-scalar, native, native-4, box2d3-wasm, rapier2d-simd, matter-js or planck; default all
# make web must have run before. The other engines are installed in build/web-bench; Scree does not depend on them. Every engine
# runs each scene three times, in turns with the others; the file gets the run with the median time. native is build/scree with one
# thread, native-4 the same with four lanes. The time per step of these two is the mean processor time of steps 101 to 300.
set -euo pipefail
. "$(dirname "$0")/../../tools/usage.sh"
cd "$(dirname "$0")/../.."
work=build/web-bench
mkdir -p $work bench/results/web
[ -d $work/node_modules/planck ] || npm install --prefix $work --no-audit --no-fund --ignore-scripts \
	@dimforge/rapier2d-simd-compat box2d3-wasm planck matter-js
rm -rf $work/node_modules/scree
cp -r build/web/package $work/node_modules/scree
cp bench/web/*.mjs $work
[ $# -gt 0 ] || set -- scree scree-scalar native native-4 box2d3-wasm rapier2d-simd matter-js planck

# user_time SCENE STEPS [OPTION ...]: prints the processor time of build/scree in user mode, in seconds
user_time() {
	local TIMEFORMAT=%U scene=$1 steps=$2
	shift 2
	{ time build/scree run "$work/$scene.json" --device cpu --threads 1 --steps "$steps" "$@" >/dev/null; } 2>&1
}
run() {
	local engine=$1 scene=$2
	case $engine in
		native*)
			local lanes=()
			[ "$engine" = native ] || lanes=(--lanes "${engine#native-}")
			node $work/native.mjs "$scene" "$work/$scene.json"
			awk -v all="$(user_time "$scene" 300 "${lanes[@]}")" -v first="$(user_time "$scene" 100 "${lanes[@]}")" \
				-v row="$engine,$scene,300" 'BEGIN { printf "%s,,%.3f,\n", row, 5 * (all - first) }'
			;;
		# planck makes only 60 steps, because a step takes 0.1 s
		planck) (cd $work && node one.mjs planck "$scene" 60) ;;
		*) (cd $work && node one.mjs "$engine" "$scene" 300) ;;
	esac | grep "^$engine,"
}
raw=$work/raw.csv out=bench/results/web/steps.csv
: >$raw
for _ in 1 2 3; do
	for scene in pyramid pile tumbler; do
		for engine in "$@"; do
			run "$engine" $scene | tee -a $raw
		done
	done
done
echo 'engine,scene,steps,start_ms,step_ms,overlap_m' >$out
for scene in pyramid pile tumbler; do
	for engine in "$@"; do
		grep "^$engine,$scene," $raw | sort -t, -k5n | sed -n 2p >>$out
	done
done
