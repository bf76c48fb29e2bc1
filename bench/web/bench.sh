#!/usr/bin/env bash
# bench.sh -- bench/web/bench.sh [ENGINE ...]: times steps under node beside engines of npm, into bench/results/web/steps.csv.
#
# make web comes first. The other engines go to build/web-bench; nothing of Scree depends on them.
set -euo pipefail
cd "$(dirname "$0")/../.."
work=build/web-bench
mkdir -p $work bench/results/web
[ -d $work/node_modules/planck ] || npm install --prefix $work --no-audit --no-fund --ignore-scripts \
	@dimforge/rapier2d-simd-compat box2d3-wasm planck matter-js
rm -rf $work/node_modules/scree
cp -r build/web/package $work/node_modules/scree
cp bench/web/*.mjs $work
out=bench/results/web/steps.csv
echo 'engine,scene,steps,start_ms,step_ms,overlap_m' >$out
for scene in pyramid pile tumbler; do
	for engine in "${@:-scree}"; do
		# planck takes 0.1 s for a step
		(cd $work && node one.mjs "$engine" $scene "$([ "$engine" = planck ] && echo 60 || echo 300)") | grep "^$engine," | tee -a $out
	done
done
