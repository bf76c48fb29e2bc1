#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_paper_commands.sh -- checks the command line of the paper's pipeline: its commands, its figures and its error
# messages.
set -uo pipefail
scree=${SCREE_BINARY:?is the path of the command line}
. "${SCREE_SOURCE:?}/tests/cli_support.sh"
begin "${scree}_paper"

small=(--device cpu --steps 5 --set rows=6)

# help and bad command lines
expect 0 'scree_paper run SCENE|FILE' help
for command in run hash bench figure5 figure6; do
	expect 0 '-h, --help' $command --help
	cp out help_by_option
	expect 0 '-h, --help' help $command
	cmp -s out help_by_option || fail "help $command: differs from $command --help"
done
refuse 2 'scree_paper: unknown command "dance"; scree_paper help lists them' dance
refuse 2 'scree_paper hash: takes no --picture' hash pile --steps 1 --picture x.png
refuse 2 'scree_paper run: takes no --lanes' run pile --lanes 4
refuse 2 'scree_paper run: takes no --threads' run pile --threads 2
refuse 2 'scree_paper bench: takes no --draw' bench pyramid --draw figure5.csv
refuse 2 '--size has no effect: there is no --picture or --video' run pile --size 640x480
refuse 2 'takes one scene or more' bench
refuse 2 'no scene is called "nothing"' bench pyramid nothing
refuse 2 'scree_paper: bridge has joints, which' run bridge --steps 1
refuse 2 'lidar casts rays, which' hash lidar --steps 1
refuse 2 'churn changes bodies between steps, which' bench pyramid churn --steps 1
refuse 2 'gpu' run pyramid --steps 1 --device gpu

# run, hash, bench
expect 0 '' hash pyramid "${small[@]}"
grep -qxE '[0-9a-f]{16}' out || fail "hash: not 16 digits alone"
paper=$(cat out)
[ "$paper" != "$("$scree" hash pyramid "${small[@]}")" ] || fail "hash: that of Scree's own pipeline"
expect 0 "$paper" run pyramid "${small[@]}" --csv rows.csv
for line in to_device integrate transform detect from_device resolve; do
	grep -qE "^ *$line " out || fail "run: no line for $line"
done
head -n 1 rows.csv | grep -q ',ms_resolve$' || fail "run --csv: another heading"
if "$program" run pyramid "${small[@]}" --picture picture.png --size 320x200 >out 2>err; then
	[ "$(head -c 4 picture.png | tail -c 3)" = PNG ] || fail "run --picture: not a PNG"
	# the picture shows bodies at their poses in the paper's pipeline
	expect 0 "$("$program" hash pyramid "${small[@]}" --steps 60)" run pyramid "${small[@]}" --steps 60 --picture end.png --size 320x200
	cmp -s picture.png end.png && fail "run --picture: the same after 5 and 60 steps"
	expect 0 '' run pyramid "${small[@]}" --picture view.png --size 320x200 --view 0,0,4,2
	expect 0 '' run pyramid "${small[@]}" --picture zoom.png --size 320x200 --zoom 0,0,4,2
	cmp -s view.png zoom.png || fail "run --zoom: its end is another picture than --view"
else
	refuse 1 'libcairo2-dev' run pyramid "${small[@]}" --picture picture.png
fi
# in the paper's pipeline this pyramid sinks deeper than the limit of the scene, so bench fails
expect 1 "$paper" bench pyramid "${small[@]}" --repeats 1
grep -q "pyramid is invalid: its deepest overlap" err || fail "bench: stacks stand"
expect 0 ',1' bench drift --set boxes=20 --steps 5 --repeats 1
cp out known.csv
expect 0 ',1' bench drift --set boxes=20 --steps 5 --repeats 1 --known known.csv
sed -E 's/,[0-9a-f]{16},1$/,0123456789abcdef,1/' known.csv >other.csv
expect 1 'but other.csv has 0123456789abcdef' bench drift --set boxes=20 --steps 5 --repeats 1 --known other.csv

# figures: both pipelines on one thread and on OpenCL; Scree's pipeline also on all threads
columns=scene,settings,pipeline,device,threads,bodies,contacts,contacts_a_body,steps,repeats,ms_step,ms_least,ms_most
stages=,ms_to_device,ms_from_device,ms_integrate,ms_transform,ms_detect,ms_resolve
stages+=,ms_broad_phase,ms_narrow_phase,ms_color,ms_solve,ms_finalize
tiny=(--steps 3 --repeats 1 --threads 2)
devices=$("$scree" devices | grep -cE '^(cpu$|opencl:)')
[ "$devices" = 1 ] || devices=2
curves=$((2 * devices + 1))
expect 0 '' figure5 "${tiny[@]}" --limit 50
[ "$(head -n 1 figure5.csv)" = "$columns,penetration,hash" ] || fail "figure5: another heading"
[ "$(grep -cE '^drift,.*,[0-9a-f]{16}$' figure5.csv)" = $((2 * curves)) ] || fail "figure5: not a row a curve and size"
awk -F, 'NF != 15 { bad = 1 } END { exit bad }' figure5.csv || fail "figure5: not a column for each name"
grep -q "figure5.csv: $((4 * curves)) rows in" err || fail "figure5: does not say how many rows"
awk -F, '/^pyramids/ && !($8 > 1 && $8 < 3 && $7 / $6 - $8 < 0.01) { bad = 1 } END { exit bad }' figure5.csv ||
	fail "figure5: contacts a body that cannot be"
if [ "$devices" = 1 ]; then
	grep -q 'no curves of OpenCL' err || fail "figure5: does not say what is missing"
	grep -qE "crossover|faster" out && fail "figure5: a crossover of one device"
else
	crossover='(no crossover of OpenCL and [12] threads? of the CPU|OpenCL is faster than [12] threads? of the CPU from [0-9]+ bodies on)'
	[ "$(grep -cE ": $crossover\$" out)" = 6 ] || fail "figure5: not a crossover of each curve, or none"
fi
# the hash is that of a run of 63 steps: one second, two steps before the measured ones, and the first measured step
hash=$("$scree" hash drift --set boxes=46 --steps 63 --device cpu)
[ "$(grep -cE "^drift,boxes=46,scree,.*,$hash\$" figure5.csv)" = $((devices + 1)) ] ||
	fail "figure5: not the hash after a second and three steps"
expect 0 '' figure5 "${tiny[@]}" --limit 25 --device cpu
[ "$(grep -c '^drift,' figure5.csv)" = 3 ] || fail "figure5 --device cpu: other curves"
grep -qE "crossover|faster" out && fail "figure5 --device cpu: a crossover"
expect 0 '' figure5 "${tiny[@]}" --limit 25 --device cpu --threads 1
[ "$(grep -c '^drift,' figure5.csv)" = 2 ] || fail "figure5 --threads 1: other curves"
expect 0 '' figure6 "${tiny[@]}" --limit 100
[ "$(head -n 1 figure6.csv)" = "$columns$stages,penetration,hash" ] || fail "figure6: another heading"
grep -qE "crossover|faster" out && fail "figure6: a crossover"
if command -v gnuplot >/dev/null; then
	for figure in figure5 figure6; do
		grep -q '</svg>' $figure.svg || fail "$figure: no SVG"
		[ "$(head -c 4 $figure.png | tail -c 3)" = PNG ] || fail "$figure: not a PNG"
		grep -q -E 'Scree, (CPU, )?1 thread' $figure.svg || fail "$figure: no legend"
	done
	grep -q 'broad phase' figure6.svg || fail "figure6: names that are no words"
fi
mkdir empty
env PATH="$scratch/empty" "$program" figure6 --draw figure6.csv >out 2>err || fail "--draw without gnuplot: a failure"
grep -q 'figure6.csv is not drawn.*gnuplot-nox' err || fail "--draw without gnuplot: no remedy"

# draws a figure from given rows. From 100 to 400 bodies, a step takes 1 to 4 ms on one thread, 2 ms at both sizes on eight
# threads, and 4 to 1 ms on OpenCL. On logarithmic axes both curves of the CPU cross the curve of OpenCL at 200 bodies
{
	echo "$columns,penetration,hash"
	for row in cpu,1,100,3,0.03,9,1,1 cpu,8,100,3,0.03,9,1,2 'opencl:A_GPU,0,100,3,0.03,9,1,4' \
		cpu,1,400,3,0.03,9,1,4 cpu,8,400,3,0.03,9,1,2 'opencl:A_GPU,0,400,3,0.03,9,1,1'; do
		echo "drift,,scree,$row,1,1,0,0123456789abcdef"
	done
} >cross.csv
expect 0 'drift, scree: OpenCL is faster than 1 thread of the CPU from 200 bodies on' figure5 --draw cross.csv
grep -qx 'drift, scree: OpenCL is faster than 8 threads of the CPU from 200 bodies on' out ||
	fail "--draw: no crossover of more threads"
if command -v gnuplot >/dev/null; then
	grep -q 'Scree, A GPU' cross.svg || fail "--draw: a name that is no word"
fi
[ "$(wc -l <out)" -le 3 ] || fail "--draw: crossovers of curves that are not there"
refuse 2 'cannot read nothing.csv' figure5 --draw nothing.csv
printf 'scene,steps\nmoon,3\n' >cross.csv
refuse 2 'cross.csv: line 2 is not a row of a figure' figure5 --draw cross.csv
refuse 2 'scree_paper figure5: takes no --set' figure5 --set rows=3
refuse 2 'scree_paper figure6: takes no --csv' figure6 --csv rows.csv
refuse 2 '--limit 0: must be' figure5 --limit 0
refuse 2 '--limit has no effect: --draw measures nothing' figure5 --draw x.csv --limit 9
rm figure5.csv && mkdir figure5.csv
refuse 1 'cannot write figure5.csv' figure5 "${tiny[@]}" --limit 25

end
