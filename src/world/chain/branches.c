// SPDX-License-Identifier: MIT
// branches.c -- finds branches: trees of joints, solved together, around light bodies that carry heavy bodies.
// The hub of a branch is a body with at least three joints that is light compared with the bodies at their other ends.
// If all joints connected to the hub form a tree, the tree is the branch. Otherwise the branch has only the joints of
// the hub and of adjacent light bodies, as far as they form a tree. The choice depends only on the user's calls, so it
// is the same on every device.
#include "world/chain/branches.h"
#include "world/objects/joints.h"
#include <string.h>

// The hub of a branch has at least HUB_JOINTS joints. For each joint, weight_of adds two ratios: mass and inertia of
// the bodies at its other end, divided by those of the hub. The sum over all joints is at least HUB_WEIGHT. When joints
// were solved one by one, hubs became unstable with welded bodies of 4 to 7 times the hub's inertia, and with hinged
// bodies of 28 to 56 times its inertia. A hinged body resists only along its arm, so only the fraction HUB_HINGE of its
// mass counts, as a mass at the hinge.
#define HUB_JOINTS 3
#define HUB_WEIGHT 3.0f
#define HUB_HINGE  0.18f
// A body with at least HUB_JOINTS joints is also a hub if all other bodies of its tree together have HUB_LOAD times its
// mass. In ragdolls the ratio is up to 9, and they come to rest without a branch.
#define HUB_LOAD 20.0f
// Maximum number of nodes of a branch, to limit its time. In larger trees, branches have only joints at light bodies.
#define MOST_NODES  1024
#define MOST_WELDED 64 // maximum number of bodies that weight_of adds up per joint; each hub has its own sums

// maximum number of joints that weight_of visits per joint; without it, the time for two bodies with n joints between them
// grows with the square of n
#define MOST_VISITED 256

typedef struct
{
	ChainSearch* s;
	int* place;   // per body that can move: 1 + its position in `list`, 0 if it is not listed
	int* list;    // bodies in the order in which they were reached
	int* through; // per listed body: joint through which it was reached, -1 for none
	int* above;   // per listed body: position in `list` of the body from which it was reached, -1 for none
} Branching;

size_t branches_bytes(size_t joints, size_t bodies)
{
	// an immovable body is listed once per joint; a branch has at least two joints, and one more node than joints
	size_t listed = joints + bodies, nodes = 2 * joints;
	return nodes * (sizeof(BranchNode) + sizeof(int)) + joints * sizeof(ChainRow) + bodies * sizeof(int) +
	       listed * 3 * sizeof(int);
}

static float distance(scree_vec a, scree_vec b) { return sqrtf((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y)); }

static bool welded(const HostJoint* host) { return host->def.coordinates[SCREE_ANGLE].locked; }

// Returns mass / hub's mass + inertia / hub's inertia, for the body at a joint's other end with all bodies welded to
// it. If the hub is hinged there, only HUB_HINGE of the mass counts, as a mass at the hinge.
static float weight_of(const scree_world* world, int joint, int hub)
{
	const HostJoint* host = world->host_joints + joint;
	int side = host->bodies[0] != hub, count = 1, visited = 0, bodies[MOST_WELDED], from[MOST_WELDED];
	const scree_pose* frames[2] = {&host->def.frame_a, &host->def.frame_b};
	const scree_mass *own = &world->host_bodies[hub].mass, *end = &world->host_bodies[host->bodies[!side]].mass;
	float arm = distance(frames[side]->position, own->center), sum = 0.0f, inertia = 0.0f, reach[MOST_WELDED];
	bodies[0] = host->bodies[!side];
	from[0] = joint;
	reach[0] = arm + distance(frames[!side]->position, end->center);
	for (int k = 0; k < count; ++k)
	{
		const HostBody* body = world->host_bodies + bodies[k];
		sum += body->mass.mass;
		inertia += body->mass.inertia + body->mass.mass * reach[k] * reach[k];
		for (int next = body->first_joint; next > 0 && count < MOST_WELDED && visited < MOST_VISITED;
		     next = joint_next(world, next), ++visited)
		{
			int other = joint_of_end(next), there = chain_other_body(world, other, bodies[k]);
			const HostJoint* more = world->host_joints + other;
			if (other == from[k] || there == hub || !welded(more) || !chain_acts(world, other) ||
			    !chain_moves(world, there))
				continue;
			int at = more->bodies[0] != bodies[k];
			const scree_pose* ends[2] = {&more->def.frame_a, &more->def.frame_b};
			bodies[count] = there;
			from[count] = other;
			reach[count++] = reach[k] + distance(ends[at]->position, body->mass.center) +
			                 distance(ends[!at]->position, world->host_bodies[there].mass.center);
		}
	}
	if (!welded(host))
	{
		sum *= HUB_HINGE;
		inertia = sum * arm * arm;
	}
	return sum / own->mass + (own->inertia > 0.0f ? inertia / own->inertia : 0.0f);
}

static int joints_of(const scree_world* world, int body)
{
	int count = 0;
	for (int end = world->host_bodies[body].first_joint; end > 0; end = joint_next(world, end))
		count += chain_acts(world, joint_of_end(end));
	return count;
}

// Returns whether a body has at least HUB_JOINTS joints, and is light compared with the bodies at their other ends.
static bool light(const scree_world* world, int body)
{
	const HostBody* hub = world->host_bodies + body;
	float weight = 0.0f;
	int count = 0;
	if (joints_of(world, body) < HUB_JOINTS) // the end of a joint to a body with thousands of others
		return false;
	if (hub->type != SCREE_BODY_DYNAMIC || hub->disabled || !(hub->mass.mass > 0.0f))
		return false;
	for (int end = hub->first_joint; end > 0; end = joint_next(world, end))
	{
		int joint = joint_of_end(end), other = chain_other_body(world, joint, body);
		if (other == body || !chain_acts(world, joint))
			continue;
		++count;
		weight += chain_moves(world, other) ? weight_of(world, joint, body) : 0.0f;
		if (count >= HUB_JOINTS && weight >= HUB_WEIGHT)
			return true;
	}
	return false;
}

static int put(Branching* b, int count, int body, int through, int above)
{
	b->list[count] = body;
	b->through[count] = through;
	b->above[count] = above;
	if (chain_moves(b->s->world, body))
		b->place[body] = count + 1;
	return count + 1;
}

// Adds to the list the bodies that joints connect to listed bodies or, if `all` is false, only to light listed bodies.
// Returns the new number of listed bodies. Sets *whole to false if a joint closes a ring or leads to another branch.
static int spread(Branching* b, int count, bool all, bool* whole)
{
	const scree_world* world = b->s->world;
	*whole = true;
	for (int k = 0; k < count; ++k)
	{
		int body = b->list[k];
		if (!chain_moves(world, body) || (!all && !light(world, body)))
			continue;
		for (int end = world->host_bodies[body].first_joint; end > 0; end = joint_next(world, end))
		{
			int joint = joint_of_end(end), other = chain_other_body(world, joint, body);
			if (joint == b->through[k] || other == body || !chain_acts(world, joint))
				continue;
			if (chain_moves(world, other) && (b->place[other] > 0 || b->s->marks[other] & BODY_BRANCHED))
				*whole = false;
			else
				count = put(b, count, other, joint, k);
		}
	}
	return count;
}

static void forget(Branching* b, int count)
{
	for (int k = 0; k < count; ++k)
		b->place[b->list[k]] = 0;
}

// Returns whether a tree has a hub: a body with at least HUB_JOINTS joints that is light compared with the bodies at
// their other ends, or with all other bodies of the tree.
static bool worth(Branching* b, int count)
{
	const scree_world* world = b->s->world;
	float all = 0.0f;
	for (int k = 0; k < count; ++k)
		all += chain_moves(world, b->list[k]) ? world->host_bodies[b->list[k]].mass.mass : 0.0f;
	for (int k = 0; k < count; ++k)
	{
		int body = b->list[k];
		if (!chain_moves(world, body) || joints_of(world, body) < HUB_JOINTS)
			continue;
		float mass = world->host_bodies[body].mass.mass;
		if (light(world, body) || all - mass >= HUB_LOAD * mass)
			return true;
	}
	return false;
}

static bool similar(const Branching* b, int count)
{
	MassRange range = mass_range();
	for (int k = 0; k < count; ++k)
		mass_range_add(&range, b->s->world, b->list[k]);
	return mass_ratio(range) <= MOST_RATIO;
}

// Adds the listed bodies as nodes of a branch. Their order is that of their distance from the first body, in joints.
static void add(Branching* b, int count)
{
	ChainLayout* layout = &b->s->layout;
	const scree_world* world = b->s->world;
	BranchNode* nodes = layout->nodes + layout->node_count;
	// an immovable first body is no node; the root is attached to it
	int skip = !chain_moves(world, b->list[0]);
	for (int k = skip; k < count; ++k)
	{
		int joint = b->through[k], n = k - skip, up = b->above[k] - skip;
		BranchNode* node = nodes + n;
		*node = (BranchNode){.body = b->list[k], .up = up < 0 ? -1 : up};
		node->side = joint >= 0 && world->host_joints[joint].bodies[1] == node->body;
		layout->node_joints[layout->node_count + n] = joint;
		if (joint >= 0)
			b->s->seen[joint] = 1;
		b->s->marks[node->body] |= chain_moves(world, node->body) ? BODY_BRANCHED : 0;
		if (node->up >= 0 && nodes[node->up].count++ == 0)
			nodes[node->up].first = n;
	}
	count -= skip;
	for (int begin = 0, end; begin < count; begin = end)
	{
		// a level has the nodes that are attached to nodes of the previous level
		for (end = begin + 1; end < count && nodes[end].up < begin;)
			++end;
		for (int k = begin; k < end; ++k)
		{
			nodes[k].begin = begin;
			nodes[k].end = end;
		}
	}
	layout->branches[layout->branch_count++] = (ChainRow){.first = layout->node_count, .count = count};
	layout->node_count += count;
}

// Lists a tree again from its first immovable body, if it has one: a joint to such a body is solved exactly only at the
// root. Returns the new number of listed bodies.
static int hang(Branching* b, int count, bool all)
{
	const scree_world* world = b->s->world;
	for (int k = 1; k < count; ++k)
	{
		if (chain_moves(world, b->list[k]))
			continue;
		int fixed = b->list[k], joint = b->through[k], body = b->list[b->above[k]];
		bool whole;
		forget(b, count);
		put(b, 0, fixed, -1, -1);
		put(b, 1, body, joint, 0);
		return spread(b, 2, all, &whole);
	}
	return count;
}

void branches_find(ChainSearch* s, void* memory)
{
	const scree_world* world = s->world;
	size_t joints = (size_t)world->joints.used, bodies = (size_t)world->bodies.used;
	ChainLayout* layout = &s->layout;
	Branching b = {.s = s};
	layout->nodes = memory;
	layout->branches = (ChainRow*)(layout->nodes + 2 * joints);
	layout->node_joints = (int*)(layout->branches + joints);
	b.place = layout->node_joints + 2 * joints;
	b.list = b.place + bodies;
	b.through = b.list + joints + bodies;
	b.above = b.through + joints + bodies;
	for (int body = 1; body < world->bodies.used; ++body)
	{
		bool tree = false;
		int count = 0;
		if (!chain_moves(world, body) || world->host_bodies[body].disabled ||
		    s->marks[body] & (BODY_BRANCHED | BODY_IN_TREE) || joints_of(world, body) < HUB_JOINTS)
			continue;
		if (!(s->marks[body] & BODY_IN_NET))
		{
			count = spread(&b, put(&b, 0, body, -1, -1), true, &tree);
			tree = tree && count <= MOST_NODES;
			for (int k = 0; k < count; ++k)
				s->marks[b.list[k]] |= tree ? BODY_IN_TREE : BODY_IN_NET;
			if (tree && worth(&b, count) && similar(&b, count))
				add(&b, count = hang(&b, count, true));
			forget(&b, count);
		}
		if (tree || !light(world, body))
			continue;
		count = spread(&b, put(&b, 0, body, -1, -1), false, &tree);
		if (count > HUB_JOINTS && similar(&b, count))
			add(&b, count = hang(&b, count, false));
		forget(&b, count);
	}
}
