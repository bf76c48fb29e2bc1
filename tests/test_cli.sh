#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_cli.sh -- checks the command line: output of each command, and exit codes and messages of calls that fail.
set -uo pipefail
scree=${SCREE_BINARY:?is the path of the command line}
. "${SCREE_SOURCE:?}/tests/cli_support.sh"
begin "$scree"

small=(--device cpu --threads 1 --steps 5 --set rows=6)

# help and versions
expect 0 'scree run SCENE|FILE' help
expect 0 '--allow-unequal-bits' run --help
expect 0 'scree hash SCENE|FILE' hash --help
grep -q -- '--picture' out && fail "hash --help: lists options of other commands"
for command in run view hash replay diff scenes devices bench 'bench frames' 'bench queries' validate; do
	read -ra words <<<"$command"
	expect 0 '-h, --help' "${words[@]}" --help
	cp out help_by_option
	expect 0 '-h, --help' help "${words[@]}"
	cmp -s out help_by_option || fail "help $command: differs from $command --help"
done
refuse 2 'scree help: unknown command "dance"' help dance
refuse 2 'scree help: unknown command "run"' help run pile
expect 0 '.' --version
expect 2 'scree run SCENE|FILE'

# bad command lines
refuse 2 'unknown command "dance"' dance
refuse 2 'unknown option --frobnicate' run pile --frobnicate
refuse 2 'takes no --picture' hash pile --steps 1 --picture x.png
refuse 2 'takes no --steps' scenes --steps 3
refuse 2 'needs a value' run pile --steps
refuse 2 '--steps 0: must be a whole number from 1' run pile --steps 0
refuse 2 '--steps -3' run pile --steps -3
refuse 2 '--steps "": must be a whole number' run pile --steps ''
refuse 2 '--steps 3x' run pile --steps 3x
refuse 2 '--threads 65: must be' run pile --threads 65
refuse 2 '--lanes 3: must be 1, 4, 8 or 16' run pile --lanes 3
refuse 2 '--set rows: must be NAME=VALUE' run pyramid --set rows
refuse 2 '--sleep yes: must be on or off' run pile --sleep yes
refuse 2 'takes no --sleep' validate --sleep on
refuse 2 '--size 10: must be WxH' run pile --size 10
refuse 2 '--picture a.jpg: must end in .png' run pile --picture a.jpg
refuse 2 '--video a.txt: must end in .mp4' run pile --video a.txt
refuse 2 '--picture and --csv name the same file: a.png' run pile --picture a.png --csv a.png
refuse 2 'unexpected argument "x"; the command takes no arguments' scenes x
refuse 2 'cannot read .: Is a directory' bench pile --known .
expect 0 'print this text' help --help
refuse 2 '--size has no effect: there is no --picture or --video' run pile --size 640x480
refuse 2 '--view 0,0,0,1: must be LEFT,BOTTOM,RIGHT,TOP' run pile --picture a.png --view 0,0,0,1
refuse 2 '--zoom 1,2,3: must be LEFT,BOTTOM,RIGHT,TOP' run pile --video a.mp4 --zoom 1,2,3
refuse 2 '--zoom has no effect: there is no --picture or --video' run pile --zoom 0,0,1,1
refuse 2 '--paint has no effect: there is no --picture or --video' run pile --paint speed
refuse 2 '--threads has no effect: the device is not the CPU' run pile --device opencl --threads 2
refuse 2 '--known has no effect' bench pile --whole --known x.csv
refuse 2 '--quick has no effect' validate --names --quick
refuse 2 'a scene is missing; the command takes one scene' run
refuse 2 'unexpected argument "pile"; the command takes one scene' run pile pile
refuse 2 'gpu' run pyramid --steps 1 --device gpu

# bad scenes
refuse 2 'no scene is called "nothing"' run nothing
refuse 2 './nothing.json' run ./nothing.json
refuse 2 '--set rows=0: must be at least 1' run pyramid --set rows=0
refuse 2 'no parameter "row" to set; there are rows' run pyramid --set row=3
refuse 2 'the scene has room for' run pyramids --set columns=700 --set rows=700 --set base=100
printf '{"name": "x",\n  "title": oops}' >bad.json
refuse 2 'bad.json: line 2, column' run bad.json
printf '{"name":"x","title":"y","attributes":{"a":{"circle":-1}},"bodies":[{"attribute":"a"}]}' >bad.json
refuse 2 'bad.json: attributes.a.circle: -1 must be positive' hash bad.json --steps 1

# lists
expect 0 'pyramid' scenes
grep -q 'rows=100' out || fail "scenes: no parameters"
expect 0 'pyramid' scenes --names
[ "$(wc -w <out)" = "$(wc -l <out)" ] || fail "scenes --names: more than one word a line"
expect 0 'equal bits' devices
expect 0 'drawing     copied' devices
head -n 1 out | grep -qx 'cpu' || fail "devices: the CPU is not the first"
# fails if SCREE_EXPECT requires OpenCL, but the command lists no OpenCL device
[[ " ${SCREE_EXPECT:-} " != *" opencl "* ]] || grep -q '^opencl:' out || fail "devices: no OpenCL, which tests are to run on"
mkdir own
printf '{"name":"ball","title":"One ball","attributes":{"a":{"circle":1}},"bodies":[{"attribute":"a"}]}' >own/ball.json
SCREE_SCENES=own expect 0 'ball' scenes --names
SCREE_SCENES=own expect 0 'bodies         1' run ball --steps 2 --device cpu
SCREE_SCENES=own expect 0 'bodies         22' run pyramid "${small[@]}"
SCREE_SCENES=own expect 0 'pyramid' scenes --names
[ "$(sort out)" = "$(cat out)" ] || fail "scenes --names: not sorted"
[ "$(grep -c -x ball out)" = 1 ] || fail "scenes --names: not one ball"
SCREE_SCENES=nowhere refuse 1 'SCREE_SCENES is "nowhere", which is no folder' scenes
SCREE_SCENES=nowhere refuse 2 'SCREE_SCENES is "nowhere", which is no folder' run pyramid "${small[@]}"

# the first scene of docs/manual/scenes.md is valid
sed -n '/^```json$/,/^```$/p' "$SCREE_SOURCE/docs/manual/scenes.md" | sed '1d;$d' >wall.json
expect 0 'bodies         82' run wall.json --steps 2 --device cpu
expect 0 'bodies         10' run wall.json --steps 2 --device cpu --set rows=1

# frames: rows that the renderer shares with the device and rows that are copied give the same picture; without a
# renderer, a message names the missing library or version
if "$scree" bench frames pyramid "${small[@]}" --size 320x200 >out 2>err; then
	[ "$(sed 1d out | wc -l)" = 2 ] || fail "bench frames: not two rows"
	[ "$(sed 1d out | cut -d, -f 11,12 | sort -u | wc -l)" = 1 ] || fail "bench frames: two pictures"
else
	grep -qE 'libepoxy-dev|libegl1|OpenGL 3.3' err || fail "bench frames: does not say what is missing"
fi
refuse 2 'no scene is called "nothing"' bench frames nothing

# queries: five rows, one per kind; two threads give the same results as one thread
"$scree" bench queries pyramid --steps 5 --queries 500 --repeats 1 --device cpu --threads 1 >one || fail "bench queries: failed"
"$scree" bench queries pyramid --steps 5 --queries 500 --repeats 1 --device cpu --threads 2 --lanes 1 >two
[ "$(sed 1d one | wc -l)" = 5 ] || fail "bench queries: not five rows"
cmp -s <(cut -d, -f 4-6,9 one) <(cut -d, -f 4-6,9 two) || fail "bench queries: other answers on two threads"
refuse 2 'no scene is called "nothing"' bench queries nothing

# rays of a scene: two threads give the same results as one thread; the rays do not change the hash of the world
few=(lidar --set robots=8 --set rays=20 --steps 10 --device cpu)
expect 0 'rays           180 a step, ' run "${few[@]}" --threads 1 --lanes 1 --csv rows.csv
head -n 1 rows.csv | grep -q ',rays,ray_hits,ms_rays$' || fail "run --csv: no columns of rays"
answers=$(sed -n 's/^hash of rays *//p' out)
grep -qE '^ms/rays +[0-9.]+ apart from the step$' out || fail "run: no time of rays"
expect 0 "$answers" run "${few[@]}" --threads 2
expect 0 "$("$scree" hash "${few[@]}")" run "${few[@]}"
expect 0 ',180,' bench "${few[@]}" --repeats 1
grep -q ",$answers,0" out || fail "bench: another hash of rays"
expect 0 'robots=1000 rays=1000' scenes
"$scree" run pyramid "${small[@]}" | grep -q rays && fail "run: rays of a scene that casts none"

# sleep: an option replaces the setting of a scene, in every command that steps one
printf '{"name":"nap","title":"y","world":{"sleep":true},"attributes":{"a":{"circle":1}},"bodies":[{"attribute":"a","asleep":true}]}' \
	>nap.json
sed 's/"sleep":true/"sleep":false/' nap.json >fall.json
nap=$("$scree" hash nap.json --steps 5 --device cpu) fall=$("$scree" hash fall.json --steps 5 --device cpu)
[ "$nap" != "$fall" ] || fail "hash: a ball that sleeps falls"
for command in hash run "bench --repeats 1" "bench --whole --repeats 1"; do
	read -ra words <<<"$command"
	expect 0 "$nap" "${words[@]}" nap.json --steps 5 --device cpu
	expect 0 "$nap" "${words[@]}" fall.json --steps 5 --device cpu --sleep on
	expect 0 "$fall" "${words[@]}" nap.json --steps 5 --device cpu --sleep off
done
expect 0 'nap,--sleep=off,' bench nap.json --repeats 1 --steps 5 --device cpu --sleep off

# snapshots: a run that goes on from a snapshot ends as a run without a break, churn included; equal states have equal snapshots
churn=(churn --device cpu --threads 1)
whole=$("$scree" hash "${churn[@]}" --steps 30)
expect 0 'steps          20 in' run "${churn[@]}" --steps 20 --save early.snap
expect 0 "$whole" run "${churn[@]}" --steps 10 --load early.snap --save late.snap
"$scree" run churn --device cpu --threads 2 --lanes 1 --steps 20 --save same.snap >/dev/null
expect 0 'equal' diff early.snap same.snap
refuse 2 'late.snap: No such file' diff early.snap nowhere/late.snap
"$scree" diff early.snap late.snap >out 2>err
[ $? = 1 ] || fail "diff: another exit code than 1"
grep -qE '^pipeline.steps  +1 of 1 differ; item 0: 0{14}14 \| 0{14}1e$' out || fail "diff: no steps"
grep -qE '^pool.pose\+4 y  +[0-9]+ of [0-9]+ differ; item [0-9]+: [0-9a-f]{8} \(.*\) \| [0-9a-f]{8} \(' out || fail "diff: no poses"
refuse 2 'rows.csv: scree_' diff early.snap rows.csv
refuse 2 'rows.csv: scree_' diff rows.csv early.snap
refuse 2 'rows.csv: scree_' run "${churn[@]}" --load rows.csv
refuse 2 'cannot read .: Is a directory' diff . early.snap
refuse 2 'cannot read .: Is a directory' diff early.snap .
refuse 2 'cannot read /dev/zero: Invalid argument' diff early.snap /dev/zero
refuse 2 'cannot read nowhere.snap: No such file' run "${churn[@]}" --load nowhere.snap
expect 0 'steps          10 in' run pyramid --device cpu --steps 10 --set rows=8 --write-scene tower.json
expect 0 'steps          5 in' run tower.json --device cpu --steps 5 --write-scene tower.json
grep -q '"name": "tower"' tower.json || fail "--write-scene: the name is not that of the file"
refuse 1 'nowhere/x.json: cannot be written: No such file or directory' run pyramid --device cpu --set rows=3 --steps 2 --write-scene nowhere/x.json
refuse 1 'cannot write nowhere/x.snap' run "${churn[@]}" --steps 2 --save nowhere/x.snap
refuse 2 'run: --record and --save name the same file: one.rec' run "${churn[@]}" --steps 2 --save one.rec --record one.rec
[ ! -e one.rec ] || fail "--record and --save: a file is written after all"

# characters, which are beside the world, are in the file too
walk=$("$scree" hash platformer --device cpu --steps 300)
expect 0 'steps          200 in' run platformer --device cpu --steps 200 --save walk.snap
expect 0 "$walk" run platformer --device cpu --steps 100 --load walk.snap
"$scree" run platforms --device cpu --steps 2 --save other.snap >/dev/null
refuse 2 'the snapshot lacks the characters' run platformer --device cpu --load other.snap

# recordings: a replay with other threads and lanes, or beside another device, has the hashes of the run
hash30=$whole
expect 0 "$hash30" run "${churn[@]}" --steps 30 --record churn.rec --hash-interval 10
expect 0 'hashes         4, all equal' replay churn.rec --device cpu --threads 2 --lanes 1
grep -qx "hash           $hash30" out || fail "replay: another hash"
expect 0 'against        cpu' replay churn.rec --device cpu --lanes 1 --against cpu
head -c "$(($(wc -c <churn.rec) - 30))" churn.rec >cut.rec
expect 0 'end            missing after' replay cut.rec --device cpu
cat churn.rec churn.rec >twice.rec
expect 0 'bytes; the rest is not read' replay twice.rec --device cpu
expect 0 "$hash30" run "${churn[@]}" --steps 10 --load early.snap --record late.rec --hash-interval 0
expect 0 'hashes         1, all equal' replay late.rec --device cpu
refuse 2 'a file is missing; the command takes one file' replay
refuse 2 'a file is missing; the command takes two files' diff early.snap
refuse 2 'early.snap: scree_replay_open: these' replay early.snap --device cpu
refuse 2 'cannot read nowhere.rec' replay nowhere.rec
refuse 1 'def.path is "nowhere/x.rec", which cannot be opened: No such file' run "${churn[@]}" --steps 2 --record nowhere/x.rec
refuse 2 '--hash-interval has no effect: there is no --record' run "${churn[@]}" --hash-interval 3
refuse 2 '--hash-interval -3: must be a whole number from 0' run "${churn[@]}" --record x.rec --hash-interval -3
refuse 2 'takes no --against' run pile --against cpu
expect 0 "$hash30" run churn --threads 1 --steps 30 --recovery-interval 5
refuse 2 '--recovery-interval has no effect: the device is the CPU' run "${churn[@]}" --recovery-interval 5
refuse 2 '--recovery-interval 0: must be' run churn --recovery-interval 0
[ -w /dev/full ] && refuse 1 '/dev/full cannot be written: No space' run "${churn[@]}" --steps 2 --record /dev/full

# hash
expect 0 '' hash pyramid "${small[@]}"
grep -qxE '[0-9a-f]{16}' out || fail "hash: not 16 digits alone"
[ "$(wc -l <out)" = 1 ] || fail "hash: not one line"
hash=$(cat out)
expect 0 "$hash" hash pyramid "${small[@]}" --threads 2 --lanes 1
expect 0 "$hash" run pyramid "${small[@]}"

# run and its files
for line in scene device bodies contacts colors steps steps/s ms/step transform broad_phase narrow_phase color solve \
	finalize penetration hash; do
	grep -qE "^ *$line " out || fail "run: no line for $line"
done
[ -s err ] && fail "run: a progress bar in a pipe"
expect 0 '' run pyramid "${small[@]}" --csv rows.csv
[ "$(wc -l <rows.csv)" = 6 ] || fail "run --csv: not a heading and one row a step"
head -n 1 rows.csv | grep -q '^step,bodies,contacts,.*,ms_finalize$' || fail "run --csv: another heading"
refuse 1 'cannot write nowhere/rows.csv' run pyramid "${small[@]}" --csv nowhere/rows.csv
if "$scree" run pyramid "${small[@]}" --picture picture.png >out 2>err; then
	[ "$(head -c 4 picture.png | tail -c 3)" = PNG ] || fail "run --picture: not a PNG"
	expect 0 '' run pyramid "${small[@]}" --picture picture.png --size 320x200
	# the last picture of a run with --zoom equals the picture of a run with --view and the same view
	expect 0 '' run pyramid "${small[@]}" --picture view.png --size 320x200 --view 0,0,4,2
	expect 0 '' run pyramid "${small[@]}" --picture zoom.png --size 320x200 --zoom 0,0,4,2
	cmp -s view.png zoom.png || fail "run --zoom: its end is another picture than --view"
	cmp -s view.png picture.png && fail "run --view: the same picture as without it"
	refuse 1 'cannot write nowhere/picture.png' run pyramid "${small[@]}" --picture nowhere/picture.png
	ln -s /dev/full full.png
	[ -w /dev/full ] && refuse 1 'cannot write full.png' run pyramid "${small[@]}" --picture full.png
	if command -v ffmpeg >/dev/null; then
		expect 0 '' run pyramid "${small[@]}" --video "it's a video.mp4" --size 321x201
		[ -s "it's a video.mp4" ] || fail "run --video: no file"
		refuse 1 'ffmpeg could not write nowhere/video.mp4' run pyramid "${small[@]}" --video nowhere/video.mp4
	fi
	env PATH="$scratch" "$scree" run pyramid "${small[@]}" --video video.mp4 >out 2>err
	[ $? = 1 ] || fail "run --video without ffmpeg: no failure"
	grep -q 'needs ffmpeg' err || fail "run --video without ffmpeg: no remedy"
else
	refuse 1 'libcairo2-dev' run pyramid "${small[@]}" --picture picture.png
fi
if [ -w /dev/full ]; then
	refuse 1 'cannot write /dev/full' run pyramid "${small[@]}" --csv /dev/full
	"$scree" hash pyramid "${small[@]}" >/dev/full 2>err
	[ $? = 1 ] || fail "hash: a full standard output is no error"
fi

# bench
heading=scene,settings,device,threads,lanes,bodies,contacts,touching,colors,steps,ms_step,ms_least,ms_most
heading+=,ms_transform,ms_broad_phase,ms_narrow_phase,ms_color,ms_solve,ms_finalize
heading+=,bytes_a_body,mb_constraints,mb_bodies,gbs_solve,gbs_copy,rays,ray_hits,ms_rays,hash_rays,penetration,hash,valid
expect 0 "$heading" bench pyramid "${small[@]}" --repeats 2
row=$(sed -n 2p out)
[ "$(tr -cd , <<<"$row")" = "$(tr -cd , <<<"$heading")" ] || fail "bench: not a column for each name"
grep -qE "^pyramid,rows=6,cpu,1,[0-9]+,22,.*,$hash,1\$" <<<"$row" || fail "bench: an unexpected row"
awk -F, '{ exit !($12 <= $11 && $11 <= $13 && $20 > 200 && $21 > 0 && $22 > 0 && $23 > 0 && $24 > 0) }' <<<"$row" ||
	fail "bench: columns that cannot be"

# an invalid row is marked, and a message names the expected value
cp out known.csv
expect 0 ",$hash,1" bench pyramid "${small[@]}" --repeats 1 --known known.csv
sed "s/,$hash,/,0123456789abcdef,/" known.csv >other.csv
expect 1 "its hash is $hash, but other.csv has 0123456789abcdef" bench pyramid "${small[@]}" --repeats 1 --known other.csv
grep -q ",$hash,0\$" out || fail "bench --known: an invalid row is not marked"
expect 0 ',1' bench pyramid --device cpu --steps 4 --set rows=6 --repeats 1 --known other.csv
refuse 2 'cannot read nothing.csv' bench pyramid "${small[@]}" --known nothing.csv
# bench/known.csv has the hashes of this version
expect 0 ',1' bench pyramid pile --steps 300 --repeats 1 --device cpu --known "$SCREE_SOURCE/bench/known.csv"
printf 'scene,steps,hash\n' >other.csv
refuse 2 'other.csv: its first line must name the columns' bench pyramid "${small[@]}" --known other.csv
printf 'scene,settings,steps,hash\npyramid,rows=6,5,xyz\n' >other.csv
refuse 2 'other.csv: line 2 is not a row' bench pyramid "${small[@]}" --known other.csv
printf '{"name":"sunk","title":"Two in one","penetration_limit":0.1,"attributes":{"a":{"circle":1}},
"bodies":[{"attribute":"a"},{"attribute":"a","position":[0.5,0]}]}' >sunk.json
expect 1 'sunk is invalid: its deepest overlap is 1.5 m, its penetration_limit 0.1' \
	bench ./sunk.json --steps 3 --device cpu --repeats 1
grep -q ',0$' out || fail "bench: a sunk pile is not marked"
refuse 2 'no scene is called "nothing"' hash nothing --steps 1
refuse 2 'no scene is called "nothing"' bench pyramid nothing

# batches: the first and the last world have the hash of the world alone, the sum is the same for all threads, lanes and runs
heading=scene,settings,device,threads,lanes,worlds,part,batches,resets,inputs,columns,bodies,steps,ms_create,ms_step,ms_least,ms_most
heading+=,world_steps_s,contacts,touching,asleep,penetration,joint_gap,hash_sum,hash_first,hash_last,hash,valid
expect 0 "$heading" bench pyramid --steps 5 --set rows=6 --worlds 30 --threads 1
cut -d, -f 1-13,25-28 out | grep -qxE "pyramid,rows=6,cpu,1,[0-9]+,30,1/1,1,0,0,0,22,5,$hash,$hash,$hash,1" ||
	fail "bench --worlds: an unexpected row"
awk -F, 'NR == 2 { exit !($14 > 0 && $16 <= $15 && $15 <= $17 && $18 > 0 && $19 == 30 * 51 && $20 == 30 * 51 && $21 == 0 && $22 > 0) }' out ||
	fail "bench --worlds: columns that cannot be"
dolls=(ragdolls --steps 20 --set columns=1 --set rows=1 --worlds 40 --resets 10 --template-steps 30)
expect 0 'columns=1 rows=1 --template-steps=30,cpu,2,' bench "${dolls[@]}" --threads 2
sum=$(sed 1d out | cut -d, -f 24-28)
expect 0 "$sum" bench "${dolls[@]}" --threads 1 --lanes 1 --repeats 1
cp out batch.csv
expect 0 "$sum" bench "${dolls[@]}" --repeats 1 --known batch.csv
expect 0 ',1' bench "${dolls[@]}" --resets 0.5 --repeats 1
grep -qF "${sum%%,*}" out && fail "bench --resets: the sum does not depend on the percentage"
sed 's/,[0-9a-f]*,1$/,0123456789abcdef,1/' batch.csv >other.csv
expect 1 'ragdolls is invalid: its hash is' bench "${dolls[@]}" --repeats 1 --known other.csv
# inputs move all worlds but the first and the last; parts of the worlds have the hashes that they have together
moved=(walker --steps 20 --worlds 40 --resets 10 --inputs --columns 20 --threads 1 --repeats 1)
expect 0 ',40,1/1,1,10,1,18,' bench "${moved[@]}"
sum=$(sed 1d out | cut -d, -f 24)
parts=0
for part in 1/3 2/3 3/3; do
	expect 0 ",$part,1,10,1,18," bench "${moved[@]}" --part $part
	parts=$((parts + 0x$(sed 1d out | cut -d, -f 24)))
done
[ "$(printf %016x $parts)" = "$sum" ] || fail "bench --part: the parts have another sum of hashes"
for batches in 2 3; do
	expect 0 "$sum" bench "${moved[@]}" --batches $batches
	grep -q ",40,1/1,$batches,10,1,18," out || fail "bench --batches: an unexpected row"
done
expect 0 "$sum" bench "${moved[@]}" --columns 1 --threads 2 --lanes 1
grep -q ',1/1,1,10,1,0,' out || fail "bench --columns 1: a pose has four columns"
expect 0 ',1' bench "${dolls[@]}" --inputs --repeats 1
refuse 2 '--part 4/3: must be K/N' bench pyramid --worlds 4 --part 4/3
refuse 2 '--part 0/3: must be K/N' bench pyramid --worlds 4 --part 0/3
refuse 2 '--part 1/5: there are 4 worlds' bench pyramid --worlds 4 --part 1/5
refuse 2 '--batches 3: there are 2 worlds' bench pyramid --worlds 4 --part 1/2 --batches 3
refuse 2 '--batches has no effect: there is no --worlds' bench pyramid --batches 2
refuse 2 '--columns 0: must be a whole number from 1' bench pyramid --worlds 4 --columns 0
refuse 2 '--inputs has no effect: there is no --worlds' bench pyramid --inputs
refuse 2 '--worlds 0: must be a whole number from 1' bench pyramid --worlds 0
refuse 2 '--resets 0: must be a number above 0' bench pyramid --worlds 4 --resets 0
refuse 2 '--resets has no effect: there is no --worlds' bench pyramid --resets 5
refuse 2 '--whole has no effect: --worlds' bench pyramid --worlds 4 --whole
refuse 2 'a scene is missing; --worlds measures no scenes but' bench --worlds 4
refuse 2 'churn has churn, which the worlds of a batch cannot have' bench pyramid churn --worlds 4
expect 2 'must have at most 4096' bench pyramid --worlds 4 --steps 2

# run --worlds: one world of a batch gives the results and the files of the world alone
alone() { grep -vE '^(steps/s|ms/step|worlds|steps|  [a-z_]*) ' out; }
for scene in 'ragdolls --set columns=1 --set rows=1' 'pile --set count=60' walker; do
	read -ra words <<<"$scene --steps 60 --device cpu"
	expect 0 'hash  ' run "${words[@]}" --save alone.snap
	alone >alone.txt
	expect 0 '9 in the batch; these are the results of world 4' run "${words[@]}" --worlds 9 --show 4 --save one.snap
	alone >one.txt
	cmp -s alone.txt one.txt || fail "run --worlds: other results than those of the world alone"
	expect 0 'hash  ' run "${words[@]}" --load alone.snap
	alone >alone.txt
	expect 0 'hash  ' run "${words[@]}" --worlds 3 --load one.snap
	alone >one.txt
	cmp -s alone.txt one.txt || fail "run --worlds --load: other results than those of the world alone"
done
few=(pyramid --set rows=6 --steps 5 --device cpu)
expect 0 "$hash" run "${few[@]}" --worlds 4 --show 3 --threads 1 --lanes 1
"$scree" run "${few[@]}" --size 320x240 --picture alone.png --write-scene one.json >out 2>err || fail "run --picture"
mv one.json alone.json
expect 0 "$hash" run "${few[@]}" --size 320x240 --picture one.png --write-scene one.json --worlds 4 --show 3
cmp -s alone.json one.json || fail "run --worlds: another scene than that of the world alone"
cmp -s alone.png one.png || fail "run --worlds: another picture than that of the world alone"
refuse 2 '--show 4: must be from 0 to 3, because --worlds is 4' run "${few[@]}" --worlds 4 --show 4
refuse 2 '--show -1: must be a whole number from 0' run "${few[@]}" --worlds 4 --show -1
refuse 2 '--show has no effect: there is no --worlds' run "${few[@]}" --show 1
refuse 2 '--csv has no effect: --worlds shows only the last state of a world' run "${few[@]}" --worlds 4 --csv x.csv
refuse 2 '--record has no effect: --worlds' run "${few[@]}" --worlds 4 --record x.rec
refuse 2 '--video has no effect: --worlds' run "${few[@]}" --worlds 4 --video x.mp4
refuse 2 '--recovery-interval has no effect: --worlds' run pyramid --worlds 4 --recovery-interval 9
refuse 2 '--layers hits shows events, which' run "${few[@]}" --worlds 4 --picture x.png --layers contacts,hits
refuse 2 'churn has churn, which the worlds of a batch cannot have' run churn --worlds 4
"$scree" run "${few[@]}" --sleep on --steps 90 >out 2>err || fail "run --sleep on"
sleeping=$(sed -n 's/^hash  *//p' out)
expect 0 "$sleeping" run "${few[@]}" --worlds 4 --show 2 --sleep on --steps 90
[ -e x.png ] && fail "run --worlds: a picture in spite of the error"

# hash --worlds: the first world has no random inputs, so one world has the hash of the scene alone; the page compares its walls
# with the sums in web/start.json
expect 0 "$hash" hash "${few[@]}" --worlds 1
expect 0 "$("$scree" hash "${few[@]}" --worlds 7 --threads 1)" hash "${few[@]}" --worlds 7 --threads 2 --lanes 1
[ "$("$scree" hash "${few[@]}" --worlds 7)" = "$("$scree" hash "${few[@]}" --worlds 8)" ] && fail "hash --worlds: worlds are equal"
walls=0
while read -r scene steps sum; do
	expect 0 "$sum" hash "$scene" --worlds 64 --steps "$steps"
	walls=$((walls + 1))
done < <(sed -nE 's/.*"name": "([a-z-]+)".*"wall": \{"steps": ([0-9]+), "sum": "([0-9a-f]+)".*/\1 \2 \3/p' "$SCREE_SOURCE/web/start.json")
[ "$walls" -ge 5 ] || fail "web/start.json has only $walls walls"
refuse 2 'churn has churn, which the worlds of a batch cannot have' hash churn --worlds 4
expect 0 "$("$scree" hash alarm-clock --steps 60)" hash alarm-clock --steps 60 --worlds 1

# validate: one experiment, and arguments that are refused; tests/test_validate.sh checks the rows of this command
expect 0 'motion,free spin for a minute,scree,change of spin,' validate --quick --device cpu --threads 1 motion
expect 0 'motion' validate --names
[ "$(wc -w <out)" = "$(wc -l <out)" ] || fail "validate --names: more than one word a line"
expect 0 'textbook motion' validate --help
refuse 2 'no experiment is called "nothing"' validate motion nothing
refuse 2 'scree validate: takes no --steps' validate --steps 3
refuse 2 'scree bench: takes no --quick' bench --quick
refuse 2 'gpu' validate --quick --device gpu motion

refuse 2 'scree bench: takes no --size' bench pyramid --size 320x200
refuse 2 'scree bench frames: takes no --repeats' bench frames pyramid --repeats 2
refuse 2 'takes one scene' bench frames

end
