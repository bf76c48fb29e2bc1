// SPDX-License-Identifier: MIT
// branch.h -- runs a pass over a branch: solves joints of a tree of bodies exactly, from its ends to its root and back.
//
// A pass that solves joint after joint around a light body that carries heavy ones leaves an error that travels around
// the light body. Warm start extrapolates this error, and bias integrates it: wheels with heavy spokes shook themselves
// apart. So the host finds such trees (src/world/chain/branches.c). Like the joints of chains, their joints have no
// color and are solved after the colors.
//
// Each node is a body with its joint toward the root. Let u be the change of the velocity of the parent body, w that of
// the node's own body, and J, K the joint's Jacobians for these bodies. The joint's impulses x satisfy (softness) x =
// goal - J u - K w. Together with all bodies below it, the node has the inertia A and gets the push f: A w = f + K^T x.
// Elimination of w gives
//
//     x = B (goal - K A^-1 f - J u),     B = (softness + K A^-1 K^T)^-1
//
// so the node acts on its parent like the inertia J^T B J and the push J^T B (goal - K A^-1 f). These inertias and
// pushes are summed from the ends to the root; then the changes are computed from the root to the ends.
//
// This work is based on:
// Roy Featherstone, The Calculation of Robot Dynamics Using Articulated-Body Inertias, 1983.
// David Baraff, Linear-Time Dynamics using Lagrange Multipliers, 1996: sparse elimination from leaf to root.
#ifndef BRANCH_H
#define BRANCH_H
#include "stages/solve/chain/branch_drive.h"

// Fraction of the yield of the parent body that is added to the yield of a joint if the node's body cannot rotate. It
// multiplies only changes of impulses, so it makes no joint softer.
#define BRANCH_GIVE   1.0e-3f
#define BRANCH_TRIALS 4 // maximum number of times that a pass is repeated because motors or limits reached their bounds

typedef struct
{
	Chain chain; // joints of the branch, in one row
	int nodes;   // index of node 0 in the pool branch
} Branch;

INLINE Branch branch_number(const Pools* p, int i)
{
	Branch branch;
	branch.chain = chain_number(p, p->chain[i].item);
	branch.nodes = branch.chain.at.odds;
	return branch;
}

#define BRANCH_EACH(k, tree)       BRANCH_SOME(k, 0, (tree)->chain.at.count)
#define BRANCH_SOME(k, begin, end) for (int k = (begin) + part_lane(); k < (end); k += part_width())
#define BRANCH_NODE(p, tree, k)    ((p)->branch[(tree)->nodes + (k)])
#define BRANCH_AT(p, tree, row, k) chain_at(p, row, (tree)->chain.at.first + (k))

#define BRANCH_BELOW(c, node) for (int c = (node).first; c < (node).first + (node).count; ++c)

// Loads the joint of a node with its bodies. A joint that broke, or is missing because the node is a root, is inert.
INLINE void branch_load(const Pools* p, const Branch* branch, int k, ChainLink* link)
{
	chain_load_posed(p, branch->chain.begin + branch->chain.at.first + k, link);
}

// Stores the impulses of a joint and the velocity changes of its bodies. branch_gather applies these changes.
INLINE void branch_keep(const Pools* p, const Branch* branch, int k, const ChainLink* link)
{
	int b = BRANCH_NODE(p, branch, k).side;
	BodyState was_a = p->body[link->ia], was_b = p->body[link->ib];
	float a[3] = {link->c.a.v.x - was_a.vx, link->c.a.v.y - was_a.vy, link->c.a.w - was_a.w};
	float other[3] = {link->c.b.v.x - was_b.vx, link->c.b.v.y - was_b.vy, link->c.b.w - was_b.w};
	joint_store(p, branch->chain.begin + branch->chain.at.first + k, PASS_BIAS, &link->u);
	for (int q = 0; q < 3; ++q)
	{
		BRANCH_AT(p, branch, m[q], k) = b ? a[q] : other[q];
		BRANCH_AT(p, branch, m[3 + q], k) = b ? other[q] : a[q];
	}
}

// Adds to each body's velocity the stored changes: from its joint toward the root, then from its other joints in order.
INLINE_MEET void branch_gather(const Pools* p, const Branch* branch)
{
	group_meet();
	BRANCH_EACH(k, branch)
	{
		BranchNode node = BRANCH_NODE(p, branch, k);
		float sum[3];
		for (int q = 0; q < 3; ++q)
			sum[q] = BRANCH_AT(p, branch, m[3 + q], k);
		BRANCH_BELOW(c, node)
		for (int q = 0; q < 3; ++q)
			sum[q] += BRANCH_AT(p, branch, m[q], c);
		if (p->body[node.body].inv_mass > 0.0f)
		{
			p->body[node.body].vx += sum[0];
			p->body[node.body].vy += sum[1];
			p->body[node.body].w += sum[2];
		}
	}
	group_meet();
}

// Runs the warm start; in bias, corrects it for rotated arms. In bias and relax, solves limits, springs and motors.
INLINE_MEET void branch_own(const Pools* p, const Branch* branch, int pass)
{
	int begin = branch->chain.begin + branch->chain.at.first;
	if (pass != PASS_RELAX)
	{
		BRANCH_EACH(k, branch)
		{
			ChainLink link;
			branch_load(p, branch, k, &link);
			chain_start(p, begin + k, pass, &link);
			branch_keep(p, branch, k, &link);
		}
		branch_gather(p, branch);
	}
	if (pass == PASS_WARM_START || !p->step.has_drives)
		return;
	for (int k = 0; k < branch->chain.at.count && part_lane() == 0; ++k)
	{
		if (!((int)joint_row(p, modes, begin + k) & JOINT_EXTRAS))
			continue;
		ChainLink link;
		branch_load(p, branch, k, &link);
		joint_drive_all(p, begin + k, pass == PASS_BIAS, &link.u, &link.c);
		joint_store(p, begin + k, PASS_BIAS, &link.u);
		body_scatter(p, link.ia, link.c.a);
		body_scatter(p, link.ib, link.c.b);
	}
	group_meet();
}

// Inverts a symmetric 3 x 3 block (00, 01, 02, 11, 12, 22) by L D L^T. least1, least2: bounds of pivots 2 and 3.
INLINE void branch_invert(const float m[6], float least1, float least2, float b[6])
{
	float d0 = quotient(1.0f, m[0]), l1 = chain_flush(m[1] * d0, ABSORBS), l2 = chain_flush(m[2] * d0, ABSORBS);
	float pivot1 = m[3] - l1 * m[1], d1 = quotient(1.0f, pivot1 > least1 ? pivot1 : least1);
	float rest = m[4] - l1 * m[2], l12 = chain_flush(rest * d1, ABSORBS);
	float pivot2 = (m[5] - l2 * m[2]) - l12 * rest, d2 = quotient(1.0f, pivot2 > least2 ? pivot2 : least2);
	float back = chain_flush(l1 * l12 - l2, ABSORBS);
	b[0] = d0 + l1 * l1 * d1 + back * back * d2;
	b[1] = chain_flush(-(l1 * d1) - l12 * back * d2, ABSORBS);
	b[2] = chain_flush(back * d2, ABSORBS);
	b[3] = d1 + l12 * l12 * d2;
	b[4] = chain_flush(-(l12 * d2), ABSORBS);
	b[5] = d2;
}

INLINE void branch_times(const float b[6], const float x[3], float y[3])
{
	y[0] = b[0] * x[0] + b[1] * x[1] + b[2] * x[2];
	y[1] = b[1] * x[0] + b[3] * x[1] + b[4] * x[2];
	y[2] = b[2] * x[0] + b[4] * x[1] + b[5] * x[2];
}

// Computes the Jacobian of a joint for its body b (parameter `b` is 1) or body a (`b` is 0): row[k] maps the
// velocity of the body, along x, along y and angular, to the speed of coordinate k.
INLINE void branch_rows(const JointPose* c, int b, const int locked[3], float row[3][3])
{
	float sign = b ? 1.0f : -1.0f;
	for (int k = 0; k < 3; ++k)
	{
		int linear = k < 2 && locked[k];
		row[k][0] = linear ? sign * c->axis[k & 1].x : 0.0f;
		row[k][1] = linear ? sign * c->axis[k & 1].y : 0.0f;
		row[k][2] = !locked[k] ? 0.0f : k == 2 ? sign : sign * (b ? c->lever_b[k & 1] : c->lever_a[k & 1]);
	}
}

typedef struct // body with all bodies below it
{
	float inverse[6], change[3]; // inverse of their inertia; velocity change of the body without its joint to the root
} BranchBody;

INLINE BranchBody branch_body(const Pools* p, const Branch* branch, BranchNode node)
{
	BranchBody body;
	BodyState now = p->body[node.body];
	float sum[9] = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f};
	if (!(now.inv_mass > 0.0f))
	{
		for (int q = 0; q < 9; ++q)
			(q < 6 ? body.inverse : body.change)[q < 6 ? q : q - 6] = 0.0f;
		return body;
	}
	int turns = now.inv_inertia > 0.0f;
	float mass = quotient(1.0f, now.inv_mass), inertia = turns ? quotient(1.0f, now.inv_inertia) : 1.0f;
	BRANCH_BELOW(c, node)
	for (int q = 0; q < 9; ++q)
		sum[q] += BRANCH_AT(p, branch, l[q], c);
	sum[0] += mass;
	sum[3] += mass;
	sum[5] = turns ? sum[5] + inertia : 1.0f;
	sum[2] = turns ? sum[2] : 0.0f;
	sum[4] = turns ? sum[4] : 0.0f;
	sum[8] = turns ? sum[8] : 0.0f;
	branch_invert(sum, mass, inertia, body.inverse);
	body.inverse[5] = turns ? body.inverse[5] : 0.0f;
	branch_times(body.inverse, sum + 6, body.change);
	return body;
}

// Reduces the softness of a joint's two linear coordinates if its angle is rigid. The softness is a fraction of the
// yield, which must not include rotation that the angle does not allow, or light ends of long arms would sag.
INLINE void branch_stiffen(const Joint* u, JointSystem* s)
{
	float impulse[2] = {u->impulse_along, u->impulse_across}, share[2] = {1.0f, 1.0f};
	if (!(s->locked[2] && joint_has(u, JOINT_LOCKED(JOINT_ANGLE)) && s->soft[2] == 0.0f))
		return;
	for (int k = 0; k < 2; ++k)
	{
		float own = s->yield[k] - s->soft[k], turn = s->cross[1 + k] * quotient(s->cross[1 + k], s->yield[2]);
		if (s->locked[k] && !joint_has(u, JOINT_SOFT(k)) && own > turn)
			share[k] = quotient(own - turn, own);
	}
	if (share[0] == 1.0f && share[1] == 1.0f)
		return;
	s->goal[0] += s->soft_cross[0] * impulse[1];
	s->goal[1] += s->soft_cross[0] * impulse[0];
	s->soft_cross[0] = 0.0f;
	for (int k = 0; k < 2; ++k)
	{
		float less = share[k] * s->soft[k];
		s->goal[k] += (s->soft[k] - less) * impulse[k];
		s->soft[k] = less;
	}
}

// Eliminates node k, after its children: computes its effect on the parent body.
INLINE void branch_up(const Pools* p, const Branch* branch, int k, int pass, int has_drives)
{
	BranchNode node = BRANCH_NODE(p, branch, k);
	BranchBody body = branch_body(p, branch, node);
	int spot = branch->chain.at.first + k, b = node.side;
	ChainLink link;
	branch_load(p, branch, k, &link);
	const JointPose* c = &link.c;
	chain_keep_pose(p, spot, c);
	float most = p->step.max_speed < JOINT_CORRECTION ? p->step.max_speed : JOINT_CORRECTION;
	JointSystem s = joint_system(p, branch->chain.begin + spot, pass == PASS_BIAS, most, &link.u, c);
	branch_stiffen(&link.u, &s);
	chain_damp(p, spot, &link, &s);
	int held = has_drives ? branch_drives(p, branch->chain.begin + spot, pass == PASS_BIAS, &link, &s) : 0;
	chain_at(p, holds, spot) = (float)held;
	float here[3][3], there[3][3], m[6], inverse[6], goal[3], y[3], answer[3][3];
	branch_rows(c, b, s.locked, here);
	branch_rows(c, !b, s.locked, there);
	const Body* above = b ? &c->a : &c->b;
	for (int i = 0, n = 0; i < 3; ++i)
	{
		branch_times(body.inverse, here[i], answer[i]);
		goal[i] = s.goal[i];
		for (int q = 0; q < 3; ++q)
			goal[i] = goal[i] - here[i][q] * body.change[q];
		goal[i] = s.locked[i] ? chain_flush(goal[i], TINY) : 0.0f;
		for (int j = i; j < 3; ++j, ++n)
		{
			float soft = i == j ? s.soft[i] : s.soft_cross[i + j - 1];
			m[n] = soft;
			for (int q = 0; q < 3; ++q)
				m[n] += answer[i][q] * here[j][q];
		}
	}
	float give = p->body[node.body].inv_inertia > 0.0f ? 0.0f : BRANCH_GIVE;
	for (int i = 0, n = 0; i < 3; n += 3 - i, ++i)
	{
		float linear = above->inv_mass * (there[i][0] * there[i][0] + there[i][1] * there[i][1]);
		m[n] = s.locked[i] ? m[n] + give * (linear + above->inv_inertia * there[i][2] * there[i][2]) : 1.0f;
	}
	branch_invert(m, JOINT_LEAST_YIELD * m[3], JOINT_LEAST_YIELD * m[5], inverse);
	branch_times(inverse, goal, y);
	for (int q = 0; q < 3; ++q)
	{
		float column[3] = {there[0][q], there[1][q], there[2][q]};
		branch_times(inverse, column, answer[q]);
	}
	for (int i = 0, n = 0; i < 3; ++i)
	{
		for (int j = i; j < 3; ++j, ++n)
			BRANCH_AT(p, branch, l[n], k) =
			    there[0][i] * answer[j][0] + there[1][i] * answer[j][1] + there[2][i] * answer[j][2];
		BRANCH_AT(p, branch, l[6 + i], k) = there[0][i] * y[0] + there[1][i] * y[1] + there[2][i] * y[2];
		BRANCH_AT(p, branch, r[i], k) = y[i];
		BRANCH_AT(p, branch, x[i], k) = body.change[i];
		for (int q = 0; q < 3; ++q)
			BRANCH_AT(p, branch, m[3 * i + q], k) = answer[i][q];
	}
	for (int n = 0; n < 6; ++n)
		BRANCH_AT(p, branch, d[n], k) = body.inverse[n];
}

// Computes the impulses of node k and the change of its velocity, from the change of the velocity of the parent body.
INLINE void branch_down(const Pools* p, const Branch* branch, int k)
{
	BranchNode node = BRANCH_NODE(p, branch, k);
	float x[3], push[3], inverse[6], change[3], sign = node.side ? 1.0f : -1.0f;
	for (int i = 0; i < 3; ++i)
	{
		x[i] = BRANCH_AT(p, branch, r[i], k);
		for (int q = 0; q < 3 && node.up >= 0; ++q)
			x[i] = x[i] - BRANCH_AT(p, branch, m[3 * q + i], k) * BRANCH_AT(p, branch, x[q], node.up);
		BRANCH_AT(p, branch, r[i], k) = x[i];
	}
	float axis_x = BRANCH_AT(p, branch, pose[0], k), axis_y = BRANCH_AT(p, branch, pose[1], k);
	float lever0 = node.side ? BRANCH_AT(p, branch, pose[4], k) : BRANCH_AT(p, branch, pose[2], k);
	float lever1 = node.side ? BRANCH_AT(p, branch, pose[5], k) : BRANCH_AT(p, branch, pose[3], k);
	push[0] = sign * (x[0] * axis_x - x[1] * axis_y);
	push[1] = sign * (x[0] * axis_y + x[1] * axis_x);
	push[2] = sign * (x[0] * lever0 + x[1] * lever1 + x[2]);
	for (int n = 0; n < 6; ++n)
		inverse[n] = BRANCH_AT(p, branch, d[n], k);
	branch_times(inverse, push, change);
	for (int q = 0; q < 3; ++q)
		BRANCH_AT(p, branch, x[q], k) += change[q];
}

INLINE_MEET void branch_solve(const Pools* p, const Branch* branch, int pass, int has_drives)
{
	for (int begin, end = branch->chain.at.count; end > 0; end = begin)
	{
		begin = BRANCH_NODE(p, branch, end - 1).begin;
		BRANCH_SOME(k, begin, end)
		branch_up(p, branch, k, pass, has_drives);
		group_meet();
	}
	for (int begin = 0, end; begin < branch->chain.at.count; begin = end)
	{
		end = BRANCH_NODE(p, branch, begin).end;
		BRANCH_SOME(k, begin, end)
		branch_down(p, branch, k);
		group_meet();
	}
}

// Sets each drive whose impulse in the solution reaches its bound to this bound. Returns whether there is such a drive.
INLINE_MEET int branch_bound(const Pools* p, const Branch* branch)
{
	int found = 0;
	BRANCH_EACH(k, branch)
	{
		int spot = branch->chain.at.first + k, held = (int)chain_at(p, holds, spot);
		ChainLink link;
		chain_load_kept(p, &branch->chain, spot, &link);
		float x[3] = {BRANCH_AT(p, branch, r[0], k), BRANCH_AT(p, branch, r[1], k), BRANCH_AT(p, branch, r[2], k)};
		chain_at(p, other, spot) = (float)branch_beyond(p, branch->chain.begin + spot, held, x, &link);
		branch_keep(p, branch, k, &link);
	}
	branch_gather(p, branch);
	for (int k = 0; k < branch->chain.at.count; ++k)
		found |= BRANCH_AT(p, branch, other, k) > 0.0f;
	group_meet();
	return found;
}

INLINE_MEET void branch_locks(const Pools* p, const Branch* branch, int pass)
{
	// drives at their bound are left out and the rest is solved again; the last trial has only unbounded locks
	int trials = p->step.has_drives ? BRANCH_TRIALS : 0;
	branch_solve(p, branch, pass, trials > 0);
	while (trials > 0 && branch_bound(p, branch))
		branch_solve(p, branch, pass, --trials > 0);
	BRANCH_EACH(k, branch)
	{
		int spot = branch->chain.at.first + k;
		ChainLink link;
		chain_load_kept(p, &branch->chain, spot, &link);
		Real x[3] = {BRANCH_AT(p, branch, r[0], k), BRANCH_AT(p, branch, r[1], k), BRANCH_AT(p, branch, r[2], k)};
		branch_drive(p, branch->chain.begin + spot, (int)chain_at(p, holds, spot), x, &link);
		chain_hold(p, spot, x, &link);
		if (pass == PASS_RELAX && p->step.has_drives)
			joint_peak(p, branch->chain.begin + spot, &link.u, &link.c);
		branch_keep(p, branch, k, &link);
	}
	branch_gather(p, branch);
}

// Item: a branch. argument: the pass.
GROUP_KERNEL(branch)
{
	(void)bench;
	Branch branch = branch_number(p, i);
	if (p->argument == PASS_BOUNCE || chain_sleeps(p, i))
		return;
	branch_own(p, &branch, p->argument);
	if (p->argument != PASS_WARM_START)
		branch_locks(p, &branch, p->argument);
}

// Sets the inertia of each body for the step, as for chains: its own inertia or, if larger, the one that the tension of
// its joints requires.
GROUP_KERNEL(branch_begin)
{
	(void)bench;
	Branch branch = branch_number(p, i);
	if (p->step.sleep)
	{
		if (part_lane() == 0)
			p->chain_live[i] = 0;
		group_meet();
		chain_look(p, i, branch.chain.at.first, branch.chain.at.count);
		group_meet();
		if (chain_sleeps(p, i))
			return;
	}
	BRANCH_EACH(k, &branch)
	chain_tension(p, &branch.chain, branch.chain.at.first + k);
	group_meet();
	BRANCH_EACH(k, &branch)
	{
		BranchNode node = BRANCH_NODE(p, &branch, k);
		float sum = node.side ? BRANCH_AT(p, &branch, tension[1], k) : BRANCH_AT(p, &branch, tension[0], k);
		BRANCH_BELOW(c, node)
		sum += BRANCH_NODE(p, &branch, c).side ? BRANCH_AT(p, &branch, tension[0], c)
		                                       : BRANCH_AT(p, &branch, tension[1], c);
		float own = p->body[node.body].inv_inertia;
		BRANCH_AT(p, &branch, inv_mass, k) = own;
		BRANCH_AT(p, &branch, turns, k) = chain_inertia(own, sum);
	}
	group_meet();
	BRANCH_EACH(k, &branch)
	{
		BranchNode node = BRANCH_NODE(p, &branch, k);
		int spot = branch.chain.at.first + k, up = node.up;
		ChainBodies bodies;
		bodies.moves_a = p->body[chain_at(p, body_a, spot)].inv_mass > 0.0f;
		bodies.moves_b = p->body[chain_at(p, body_b, spot)].inv_mass > 0.0f;
		chain_at(p, slack, spot) = chain_slack(p, spot, &bodies);
		float here = BRANCH_AT(p, &branch, turns, k);
		float there = up >= 0 ? BRANCH_AT(p, &branch, turns, up) : 0.0f;
		chain_at(p, step_a, spot) = node.side ? there : here;
		chain_at(p, step_b, spot) = node.side ? here : there;
	}
	group_meet();
	BRANCH_EACH(k, &branch)
	{
		int body = BRANCH_NODE(p, &branch, k).body;
		if (p->body[body].inv_mass > 0.0f)
			p->body[body].inv_inertia = BRANCH_AT(p, &branch, turns, k);
	}
}

GROUP_KERNEL(branch_end)
{
	(void)bench;
	Branch branch = branch_number(p, i);
	if (chain_sleeps(p, i))
		return;
	BRANCH_EACH(k, &branch)
	{
		int body = BRANCH_NODE(p, &branch, k).body;
		if (p->body[body].inv_mass > 0.0f)
			p->body[body].inv_inertia = BRANCH_AT(p, &branch, inv_mass, k);
	}
}

#endif
