#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_rollback.sh -- plays the example of rollback: two peers over UDP, on the CPU and through OpenCL, with delay, loss and reordering.
# All confirmed hashes must agree. A peer whose world differs, a peer that leaves and packets of strangers must be noticed.
set -uo pipefail
. "${SCREE_SOURCE:?}/tests/cli_support.sh"
begin "${SCREE_BUILD:?}/rollback"
bad=(--delay 60 --jitter 30 --loss 10 --reorder 10)
fast=(--speed 4 --wait 300000 --timeout 30000)

# row TEXT: prints the values of both peers in a row of the table
row()
{
	sed -n "s/^$1  *//p" out
}

# play TEXT words...: plays a game of 600 frames with both peers, which must end well, with rollbacks and 601 equal hashes
play()
{
	expect 0 "$1" --demo "${fast[@]}" "${@:2}"
	[ "$(row 'hashes compared' | xargs)" = "601 601" ] || fail "$*: not all hashes were compared"
	[ "$(row differences | xargs)" = "0 0" ] || fail "$*: hashes differ"
	local first second
	read -r first second < <(row rollbacks)
	[ "$first" -gt 5 ] && [ "$second" -gt 5 ] || fail "$*: $first and $second rollbacks"
	read -r first second < <(row 'longest rollback, frames')
	[ "$first" -le 8 ] && [ "$second" -le 8 ] || fail "$*: rollbacks of $first and $second frames"
}

expect 0 '--demo' --help
refuse 2 '--frames 0: must be a whole number from 1' --frames 0
refuse 2 'unknown option --dance' --dance
refuse 1 'def.lanes is 3' --demo --lanes 3

# lanes, threads and the network change no hash: the line of frame 600 is the same in all games
play 'frame 600 is confirmed' "${bad[@]}" --threads 2,1 --lanes 1,4 --record
hash=$(sed -n 's/.*frame 600 is confirmed, .*hash \([0-9a-f]*\) of frame 600.*/\1/p' out | sort -u)
[ "${#hash}" = 16 ] || fail "frame 600 has the hashes $hash"
play "hash $hash of frame 600" --threads 1 --delay 300 --loss 40 --speed 16
play 'frame 600 is confirmed' --speed 8 --threads 1 "${bad[@]}" --input-delay 2,0
if [ -x "${SCREE_BINARY:-}" ]; then
	for peer in 0 1; do
		"$SCREE_BINARY" replay "rollback_peer$peer.rec" --device cpu --threads 1 >out 2>err || fail "the recording of peer $peer differs"
	done
fi

# lockstep: no prediction
expect 0 'frame 600 is confirmed' --demo "${fast[@]}" "${bad[@]}" --speed 8 --threads 1 --prediction 0 --input-delay 4
[ "$(row rollbacks | xargs)" = "0 0" ] || fail "rollbacks in lockstep"
[ "$(row 'hashes compared' | xargs)" = "601 601" ] || fail "lockstep: not all hashes were compared"
refuse 2 '--prediction 0 needs an --input-delay' --demo --prediction 0,8

# From frame 100 on, crates of peer 1 have another density. The next crate falls in frame 120, so state 121 is the first to differ.
expect 1 'peer 0: state 121 differs' --demo "${fast[@]}" "${bad[@]}" --threads 1 --diverge 0,100
grep -q 'peer 1: state 121 differs' err || fail "peer 1 has not found the difference"
if [ -x "${SCREE_BINARY:-}" ]; then
	"$SCREE_BINARY" diff rollback_peer0_state121.snapshot rollback_peer1_state121.snapshot >out 2>err
	grep -q 'pool.body' out || fail "the snapshots of both peers do not differ in a body"
fi

expect 1 'peer 0: state 126 differs' --demo "${fast[@]}" --speed 16 --threads 1 --diverge 0,100 --hash-interval 7

# Two processes on ports of their own; the second begins later and ends early.
port=$((20000 + $$ % 10000))
"$program" --peer 0 --port $port --threads 1 --timeout 20000 >first 2>&1 &
first=$!
sleep 1
expect 1 "UDP port $port cannot be used" --peer 0 --port $port
"$program" --peer 1 --port $port --threads 1 --timeout 20000 >second 2>&1 &
second=$!
for size in 1 7 46 700; do # packets of a stranger
	head -c $size /dev/urandom >/dev/udp/127.0.0.1/$port
done
sleep 2
kill $second
wait $first
[ $? = 1 ] || fail "the exit code is not 1, although the other peer has left"
cp first out
cp second err
grep -q 'peer 0: peer 1 has left, at frame' first || fail "peer 0 has not noticed that peer 1 has left"
grep -q 'peer 1: stopped by signal 15' second || fail "peer 1 does not say why it stops"
[ "$(row 'packets ignored, foreign or damaged')" = 4 ] || fail "packets of a stranger were not counted"

# the CPU against OpenCL
"$program" --demo "${fast[@]}" --frames 1 --device cpu,opencl >out 2>err
if grep -q 'There is no OpenCL' err; then
	cat err
	[[ " ${SCREE_EXPECT:-} " != *" opencl "* ]] || fail "no OpenCL, on which tests are to run"
	[ "$failures" = 0 ] && { echo "skipped: OpenCL"; exit 77; }
else
	play "hash $hash of frame 600" "${bad[@]}" --device cpu,opencl --threads 2 --lanes 4
	sed -n '/^ /,$p' out
fi
end
