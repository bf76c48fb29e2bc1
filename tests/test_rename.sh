#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_rename.sh -- checks that tools/rename.sh ports a program with old names, which then compiles. docs/manual/names.md lists the names.
set -uo pipefail
source=${SCREE_SOURCE:?is the folder of the sources}
header=$source/include/scree/scree.h
scratch=$(mktemp -d "${SCREE_BUILD:?}/test_rename.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
failures=0
fail()
{
	echo "FAILED: $*"
	failures=$((failures + 1))
}

# expect CODE TEXT ARGUMENT...: checks that rename.sh ends with this exit code and prints the text
expect()
{
	local code=$1 text=$2 got
	shift 2
	"$source/tools/rename.sh" "$@" >out 2>&1
	got=$?
	[ "$got" = "$code" ] || fail "rename.sh $*: exit code $got instead of $code"
	grep -qF -- "$text" out || { fail "rename.sh $*: does not say \"$text\", but"; cat out; }
}

# checks that scree.h has each new name of docs/manual/names.md, has each new member in the struct of its row, and has no old name
struct_of()
{
	sed -n "/^typedef struct $1\b/,/^} $1;/p" "$header" | sed 's://.*::'
}
rows=0
while read -r old new; do
	rows=$((rows + 1))
	grep -qw "$new" "$header" || fail "docs/manual/names.md: scree.h has no $new"
	grep -qw "$old" "$header" && fail "docs/manual/names.md: scree.h still has $old"
done < <(sed -nE 's/^\| `(scree_[a-z_]+|SCREE_[A-Z_]+)` \| `(scree_[a-z_]+|SCREE_[A-Z_]+)` \|.*/\1 \2/p' "$source/docs/manual/names.md")
while read -r struct old new; do
	rows=$((rows + 1))
	struct_of "$struct" | grep -qw "$new" || fail "docs/manual/names.md: $struct has no member $new"
	struct_of "$struct" | grep -qw "$old" && fail "docs/manual/names.md: $struct still has the member $old"
done < <(sed -nE 's/^\| `(scree_[a-z_]+)` \| `([a-z_]+)` \| `([a-z_]+)` \| (by struct|everywhere) \|$/\1 \2 \3/p' "$source/docs/manual/names.md")
[ $rows -ge 28 ] || fail "docs/manual/names.md: has only $rows names"

# a program with every old name, and with a name of its own that must not change
cat >game.c <<'C'
// game.c -- scree_world_get_moved fills a scree_moved_list; SCREE_HUGE bounds it.
#include <scree/scree.h>
#include <stdio.h>

typedef struct
{
	scree_counters counters;
	int held, slope;
} Game;

static int count_moved(scree_world* world)
{
	scree_moved_list list;
	scree_found found;
	scree_found_list lists[2];
	if (scree_world_get_moved(world, &list) || scree_world_cast_ray(world, (scree_vec){0}, (scree_vec){0, -1}, &found) ||
	    scree_world_overlap_point(world, (scree_vec){0}, &lists[0]))
		return 0;
	const scree_moved* first = list.moved;
	return list.count + (int)first->user + (int)lists[0].found[0].fraction + found.hit + (int)list.moved_size;
}

static int read_events(scree_world* world, const scree_events* events)
{
	bool answers[16] = {false};
	for (int k = 0; k < events->asked_count && k < 16; ++k)
		answers[k] = events->asked[k].count > 0;
	return scree_world_answer_asked(world, answers, events->asked_count) == SCREE_ERROR_CROWDED;
}

static float make(scree_joint_def* joint, scree_mover* mover, const scree_device* device)
{
	scree_mover_def def = {.slope = 1.0f, /* .climb */ .climb = 0.5f,
	                       .snap = 0.1f};
	scree_joint_side sides[2] = {{.near = 1.0f}, {.near = 2.0f}};
	joint->breaks = true;
	joint->path_near = sides[0].near;
	return mover->carried.x + def.slope + def.climb + def.snap + (float)device->units + SCREE_HUGE;
}

int main(void)
{
	Game game = {.held = 1, .slope = 2};
	scree_counters counters = {.nonfinite = 1, .grown = 2}, *all = &counters;
	scree_body_def body = scree_body_def_default();
	body.reports = SCREE_REPORT_ASKS;
	scree_joint_def joint = scree_joint_def_make(SCREE_JOINT_PATH);
	game.counters = (scree_counters){.held = counters.held + all->moved};
	printf("%s: %d held", scree_opencl_remedy(), game.held + game.slope + game.counters.grown);
	return count_moved(NULL) + read_events(NULL, NULL) + (int)make(&joint, NULL, NULL) + body.reports == 3;
}
C
cat >game.mjs <<'JS'
world.answerAsked(world.getEvents().asked);
world.createJoint({pathNear: 1, breaks: `${body.held} held`}); // Report.ASKS
if (status === Status.ERROR_CROWDED) throw Report.ASKS
JS
truncate -s -1 game.mjs
chmod 750 game.c
cp game.c old.c
cp game.mjs old.mjs

# a wrong argument prevents all changes
mkdir folder.c
printf 'a\0b' >binary.c
expect 2 'rename.sh: names no file'
expect 2 'rename.sh: there is no file missing.c' game.c missing.c
expect 2 'rename.sh: folder.c is not a file' game.c folder.c
expect 2 'rename.sh: out is not called like a file of C, C++ or JavaScript' game.c out
expect 2 'rename.sh: binary.c is not text' game.c binary.c
expect 2 'rename.sh: unknown option --frobnicate' --frobnicate game.c
expect 2 'rename.sh: unknown option -x' game.c -x
expect 0 'usage: tools/rename.sh FILE...' -h
expect 0 'usage: tools/rename.sh FILE...' --help
cmp game.c old.c || fail "rename.sh: changes a file in spite of an error"

# names with exactly one meaning are changed; ambiguous names are reported
expect 0 'rename.sh: changed 2 of 2 files; 8 names are left to you' game.c game.mjs
cat >wanted <<'TEXT'
game.c:43: held may be stopped_bodies instead
game.c:43: slope may be max_slope instead
game.c:49: held may be stopped_bodies instead
game.c:49: slope may be max_slope instead
game.c:49: grown may be reallocations instead
game.mjs:1: asked may be approvals instead
game.mjs:2: breaks may be canBreak instead
game.mjs:2: held may be stoppedBodies instead
TEXT
grep ' instead$' out | diff wanted - || fail "rename.sh: reports other names"
[ "$(stat -c %a game.c)" = 750 ] || fail "rename.sh: the mode of game.c is another one"
[ -n "$(tail -c 1 game.mjs)" ] || fail "rename.sh: adds an end of line to game.mjs"
cat >wanted <<'JS'
world.approveContacts(world.getEvents().asked);
world.createJoint({initialAlong: 1, breaks: `${body.held} held`}); // Report.ASKS
if (status === Status.ERROR_CONTACT_LIMIT) throw Report.APPROVAL
JS
diff wanted <(cat game.mjs && echo) || fail "rename.sh: game.mjs is another one"
head -n 1 game.c | grep -qxF '// game.c -- scree_world_get_moved_bodies fills a scree_moved_bodies; SCREE_MAX_COORDINATE bounds it.' ||
	fail "rename.sh: the comment at the head of game.c is another one"
cp game.c once.c
expect 0 'rename.sh: changed 0 of 1 files' game.c
cmp game.c once.c || fail "rename.sh: changes the new names"

# variables of C++ with a second type, which templates, references, auto, loops, captures and macros declare, are reported
cat >cups.C <<'CPP'
struct Cup { int held, slope; };
int f1(scree_counters a) { return a.held; }
int f2(std::unique_ptr<Cup> a) { return a->held; }
int g1(scree_counters b) { return b.held; }
int g2(std::vector<std::map<int, Cup>>& b) { return b[0].held; }
int h1(scree_counters c) { for (auto& c : cups) c.held = 0; }
int i1(scree_counters d) { auto [d, e] = pair(); return d.held; }
int j1(scree_counters f) { return [f = Cup()] { return f.held; }(); }
int k1(scree_counters g) { decltype(cup) g; return g.held; }
int l1(scree_counters h) { Cup h(1); return h.held; }
int m1(scree_counters i) { game::scree_counters i; return i.held + Cup::i.held; }
int n1(scree_counters j) { struct { int held; } *j; return j->held; }
#define HELD(k) \
	k.held
int o1(std::vector<scree_counters> l) { return l[0].held; }
int p1(scree_counters&& k, int n) { return n < 3 && n > 1 ? k.held : f1(k); }
CPP
expect 0 'rename.sh: changed 1 of 1 files; 14 names are left to you' cups.C
grep -n stopped_bodies cups.C | cut -d: -f1 | diff <(echo 16) - || fail "rename.sh: changes members of other types in cups.C"

# members behind offsetof, ::, raw strings and strings of several lines
cat >places.ipp <<'CPP'
auto a = offsetof(struct scree_counters, held) + offsetof(scree_counters, held);
auto b = offsetof(Counters, held) + container_of(p, scree_counters, held);
auto c = &scree_counters::held; auto d = &Counters::held;
scree_counters n; auto e = R"(a " b)"; int f = n.held;
auto g = u8R"x()" n.held
 ' n.held)x"; int h = n.held;
auto i = "a \
 it's"; int j = n.held; // comment \
 it's n.held
auto k = offsetof(scree_joint_def, n.near);
CPP
cat >wanted <<'CPP'
auto a = offsetof(struct scree_counters, stopped_bodies) + offsetof(scree_counters, stopped_bodies);
auto b = offsetof(Counters, held) + container_of(p, scree_counters, held);
auto c = &scree_counters::stopped_bodies; auto d = &Counters::held;
scree_counters n; auto e = R"(a " b)"; int f = n.stopped_bodies;
auto g = u8R"x()" n.held
 ' n.held)x"; int h = n.stopped_bodies;
auto i = "a \
 it's"; int j = n.stopped_bodies; // comment \
 it's n.held
auto k = offsetof(scree_joint_def, n.near);
CPP
expect 0 'rename.sh: changed 1 of 1 files; 4 names are left to you' places.ipp
diff wanted places.ipp || fail "rename.sh: places.ipp is another one"

# regular expressions of JavaScript do not begin comments, strings or templates; a division does not begin one
cat >regex.mjs <<'JS'
const t = s.replace(/`/g, ""); w.answerAsked(1);
const r = /[/*]/, q = /[\]/'`]\/"/u; w.answerAsked(2);
if (x) /`/.test(y); w.answerAsked(3);
const f = x => /'/.test(x); w.answerAsked(4);
const d = (a) / b / `${/`/.test(c) / 2}` / 2; w.answerAsked(5);
i++ / 2; j = "`" / 2; k = l[0] / 2; m = 'a \
 `' / 2; w.answerAsked(6);
const n = a
	/ b / `${c}`; w.answerAsked(7);
return /`/; w.answerAsked(8);
JS
expect 0 'rename.sh: changed 1 of 1 files; 0 names are left to you' regex.mjs
[ "$(grep -c 'w\.approveContacts([1-8])' regex.mjs)" = 8 ] || fail "rename.sh: does not read the regular expressions"

# keys and patterns of JavaScript; {NAME} is a variable too
cat >keys.mjs <<'JS'
const o = {"pathNear": 1, 'breaks': true, ["pathNear"]: 2};
o["pathNear"] = o?.pathNear + o?.["pathNear"] + o["held"];
const {held = 0, grown} = w.getCounters(), {pathNear = 0} = o;
const {ERROR_CROWDED} = Status, {Report: {ASKS}} = scree, {ERROR_CROWDED: crowded} = other;
w.createJoint({pathNear}); f(a, pathNear, [...pathNear], x ? pathNear : y);
export {pathNear};
Status["ERROR_CROWDED"] + Status?.ERROR_CROWDED + other.ERROR_CROWDED + ["held"];
JS
cat >wanted <<'JS'
const o = {"initialAlong": 1, 'breaks': true, ["initialAlong"]: 2};
o["initialAlong"] = o?.initialAlong + o?.["initialAlong"] + o["held"];
const {held = 0, grown} = w.getCounters(), {initialAlong: pathNear = 0} = o;
const {ERROR_CONTACT_LIMIT: ERROR_CROWDED} = Status, {Report: {APPROVAL: ASKS}} = scree, {ERROR_CROWDED: crowded} = other;
w.createJoint({initialAlong: pathNear}); f(a, pathNear, [...pathNear], x ? pathNear : y);
export {pathNear};
Status["ERROR_CONTACT_LIMIT"] + Status?.ERROR_CONTACT_LIMIT + other.ERROR_CROWDED + ["held"];
JS
expect 0 'rename.sh: changed 1 of 1 files; 8 names are left to you' keys.mjs
diff wanted keys.mjs || fail "rename.sh: keys.mjs is another one"

# each extension of C++ is accepted
for extension in C H cc hh cpp hpp cxx hxx inl ipp tpp; do
	echo scree_found >"one.$extension"
	expect 0 'rename.sh: changed 1 of 1 files' "one.$extension"
done

# the program compiles after the one reported member is changed by hand
sed -i 's/counters\.grown/counters.reallocations/' game.c
compiler=$(command -v "${CC:-cc}" || command -v gcc || command -v clang) || { echo "skipped: there is no compiler"; exit 77; }
"$compiler" -std=c17 -Wall -Wextra -Werror -fsyntax-only -I "$source/include" game.c || fail "the ported program does not compile"
"$compiler" -std=c17 -fsyntax-only -I "$source/include" old.c 2>err && fail "the old program compiles as well"
[ $failures = 0 ]
