// SPDX-License-Identifier: MIT
// test_formulas.c -- checks kernels whose items are independent, called as functions, against formulas in double
// precision.
#include "support/make_worlds.h"
#include "tools/common/random_numbers.h"
#include <math.h>
#include <string.h>

#include "support/stage_items.h"

#include "stages/broad_phase/transform.h"
#include "stages/finalize/finalize.h"
#include "stages/read/query.h"
#include "stages/solve/integrate.h"
#include "stages/solve/solve_pass.h"

#define ITEMS 64 // capacity of each pool

static void open_pools(Pools* p)
{
#define X(type, name, per, role) p->name = scree_allocate(ITEMS * sizeof(type));
#include "pools/pools.def"
#undef X
}

static void close_pools(Pools* p)
{
#define X(type, name, per, role) scree_release(p->name);
#include "pools/pools.def"
#undef X
}

// ---------------------------------------------------------------------------------------------------------------
// boxes and rotations
// ---------------------------------------------------------------------------------------------------------------

// A box of 2 m by 1 m lies at (3, 0) in the frame of a body. The center of mass is at (1, 0) in this frame, and at (10,
// 20) in the world. After a rotation R by t, vertex v is at (10, 20) + R ((3, 0) - (1, 0) + v). The tight box contains
// the shape and half of the speculative distance on each side. The enlarged box contains the tight box and the margin
// on each side. It stays the same until the tight box leaves it.
static void boxes_follow_bodies(void** state)
{
	(void)state;
	Attribute attribute = {
	    .vertices = {{-1.0f, -0.5f}, {1.0f, -0.5f}, {1.0f, 0.5f}, {-1.0f, 0.5f}}, .count = 4, .margin = 0.125f};
	const double turns[] = {0.0, 0.001, 0.05, 0.7, 2.5, -1.3};
	const bool leaves[] = {true, false, true, true, true, true};
	Pools p = {0};
	open_pools(&p);
	const int item = 2, body = 3;
	p.attribute[1] = attribute;
	p.collidable_pose[item] = make_float4(3.0f, 0.0f, 1.0f, 0.0f);
	p.collidable_attribute[item] = 1;
	p.collidable_body[item] = body;
	p.collidable_kind[item] = KIND_DYNAMIC;
	p.box[item] = p.old_box[item] = box_empty();
	p.local_center[body] = make_float2(1.0f, 0.0f);
	for (int turn = 0; turn < 6; ++turn)
	{
		double c = cos(turns[turn]), s = sin(turns[turn]), low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
		Float4 old = p.box[item];
		p.pose[body] = make_float4(10.0f, 20.0f, (float)c, (float)s);
		int listed = transform_item(&p, item);
		WorldShape placed = p.world_shape[item];
		NEAR(placed.x, 10.0 + 2.0 * c, 1e-5);
		NEAR(placed.y, 20.0 + 2.0 * s, 1e-5);
		NEAR(placed.x + placed.center_x, 10.0, 1e-5);
		NEAR(placed.y + placed.center_y, 20.0, 1e-5);
		assert_int_equal(p.collidable_flags[item], leaves[turn]);
		assert_int_equal(listed, leaves[turn] ? item : -1);
		assert_memory_equal(p.old_box + item, &old, sizeof old);
		if (!leaves[turn])
		{
			assert_memory_equal(p.box + item, &old, sizeof old);
			continue;
		}
		for (int v = 0; v < 4; ++v)
		{
			double x = 2.0 + attribute.vertices[v].x, y = attribute.vertices[v].y;
			double at[2] = {10.0 + c * x - s * y, 20.0 + s * x + c * y};
			for (int axis = 0; axis < 2; ++axis)
			{
				low[axis] = at[axis] < low[axis] ? at[axis] : low[axis];
				high[axis] = at[axis] > high[axis] ? at[axis] : high[axis];
			}
		}
		double around = 0.5 * SPECULATIVE_DISTANCE + attribute.margin;
		NEAR(p.box[item].x, low[0] - around, 1e-5);
		NEAR(p.box[item].y, low[1] - around, 1e-5);
		NEAR(p.box[item].z, high[0] + around, 1e-5);
		NEAR(p.box[item].w, high[1] + around, 1e-5);
	}

	// the box of a destroyed collidable is empty and is marked as updated, so its contacts end
	p.collidable_kind[item] = KIND_DEAD;
	transform_item(&p, item);
	assert_true(p.collidable_flags[item] && box_is_empty(p.box[item]));
	close_pools(&p);
}

// The error |vec_rotation(a) - (cos a, sin a)| is below 2e-7 for angles up to 1 radian, and below 2.3e-5 up to pi.
// Ordinary steps turn by less than 0.1 radian; there the error is one or two roundings, below 6e-8.
static void rotations_are_exact_enough(void** state)
{
	(void)state;
	double worst = 0.0, worst_common = 0.0, worst_small = 0.0;
	for (int k = -200000; k <= 200000; ++k)
	{
		float angle = (float)(PI * k / 200000.0);
		Vec q = vec_rotation(angle);
		double error = hypot(q.x - cos(angle), q.y - sin(angle));
		worst = error > worst ? error : worst;
		if (fabsf(angle) <= 1.0f && error > worst_common)
			worst_common = error;
		if (fabsf(angle) < 0.1f && error > worst_small)
			worst_small = error;
	}
	assert_true(worst < 2.3e-5 && worst_common < 2e-7 && worst_small < 6e-8);
}

// ---------------------------------------------------------------------------------------------------------------
// warm starting
// ---------------------------------------------------------------------------------------------------------------

// number of bodies, and of contacts, which join each body and the next; contacts with even indices have one color,
// those with odd indices another
#define CHAIN 48

static void make_chain(Pools* p)
{
	uint64_t seed = 99;
	const float h = 1.0f / 240.0f;
	p->step = (Step){.dt = 4.0f * h,
	                 .h = h,
	                 .inv_h = 1.0f / h,
	                 .gravity_y = -10.0f,
	                 .max_speed = 400.0f,
	                 .max_spin = 100.0f,
	                 .push_speed = 3.0f,
	                 .pair = {8.0f, 0.9f, 0.1f, 0.5f, 0.002f},
	                 .fixed = {16.0f, 0.95f, 0.05f, 3.0f, 0.001f}};
	for (int k = 0; k < CHAIN; ++k)
	{
		bool moves = k % 7 != 3;
		p->body[k] = (BodyState){.vx = random_between(&seed, -1.0f, 1.0f),
		                         .vy = random_between(&seed, -1.0f, 1.0f),
		                         .w = random_between(&seed, -1.0f, 1.0f),
		                         .inv_mass = moves ? random_between(&seed, 0.5f, 2.0f) : 0.0f,
		                         .inv_inertia = moves ? random_between(&seed, 2.0f, 9.0f) : 0.0f};
		p->motion[k] = (Motion){.gravity_scale = moves ? 1.0f : 0.0f, .free_x = 1.0f, .free_y = 1.0f};
		p->base[k] = make_float4(p->body[k].vx, p->body[k].vy, p->body[k].w, 0.0f);
		contact_row(p, body_a, k) = k;
		contact_row(p, body_b, k) = (k + 1) % CHAIN;
		float turn = random_between(&seed, -3.0f, 3.0f);
		contact_row(p, normal_x, k) = cosf(turn);
		contact_row(p, normal_y, k) = sinf(turn);
		contact_row(p, friction, k) = 0.6f;
		contact_row(p, offset_x, k) = random_between(&seed, -1.0f, 1.0f);
		contact_row(p, offset_y, k) = random_between(&seed, -1.0f, 1.0f);
		contact_row(p, anchor1_x, k) = random_between(&seed, -0.5f, 0.5f);
		contact_row(p, anchor1_y, k) = random_between(&seed, -0.5f, 0.5f);
		contact_row(p, anchor2_x, k) = random_between(&seed, -0.5f, 0.5f);
		contact_row(p, anchor2_y, k) = random_between(&seed, -0.5f, 0.5f);
		contact_row(p, separation1, k) = random_between(&seed, -0.01f, 0.005f);
		contact_row(p, separation2, k) = k % 3 ? random_between(&seed, -0.01f, 0.005f) : NO_POINT;
		contact_row(p, normal_impulse1, k) = random_between(&seed, 0.0f, 0.1f);
		contact_row(p, normal_impulse2, k) = k % 3 ? random_between(&seed, 0.0f, 0.1f) : 0.0f;
		contact_row(p, tangent_impulse1, k) = random_between(&seed, -0.05f, 0.05f);
	}
}

// Calls a kernel for each contact of the chain, one color after the other.
static void pass(const Pools* p, void (*stage)(const Pools* p, int i))
{
	for (int color = 0; color < 2; ++color)
		for (int k = color; k < CHAIN; k += 2)
			stage(p, k);
}

// A plain substep adds h g to the velocities, adds the impulses so far of all contacts by a pass, and then does bias,
// move and relax. The solver saves this pass, except in the first substep: it starts from the velocities in the pool
// base. Velocities and impulses of both methods are equal except for rounding.
static void warm_start_equals_plain(void** state)
{
	(void)state;
	Pools kept = {0}, plain = {0};
	open_pools(&kept);
	open_pools(&plain);
	make_chain(&kept);
	make_chain(&plain);
	pass(&kept, contact_warm_start_item);
	for (int substep = 0; substep < 8; ++substep)
	{
		kept.argument = substep == 0;
		for (int k = 0; k < CHAIN; ++k)
		{
			BodyState* body = plain.body + k;
			plain.base[k] = make_float4(body->vx, body->vy, body->w, 0.0f);
			integrate_velocity_item(&kept, k);
			integrate_velocity_item(&plain, k);
		}
		pass(&plain, contact_warm_start_item);
		for (int side = 0; side < 2; ++side)
		{
			Pools* p = side ? &plain : &kept;
			pass(p, contact_bias_item);
			for (int k = 0; k < CHAIN; ++k)
				integrate_position_item(p, k);
			pass(p, contact_relax_item);
		}
		for (int k = 0; k < CHAIN; ++k)
		{
			NEAR(kept.body[k].vx, plain.body[k].vx, 2e-5);
			NEAR(kept.body[k].vy, plain.body[k].vy, 2e-5);
			NEAR(kept.body[k].w, plain.body[k].w, 1e-4);
			NEAR(contact_row(&kept, normal_impulse1, k), contact_row(&plain, normal_impulse1, k), 2e-5);
			NEAR(contact_row(&kept, tangent_impulse1, k), contact_row(&plain, tangent_impulse1, k), 2e-5);
		}
	}
	close_pools(&kept);
	close_pools(&plain);
}

// ---------------------------------------------------------------------------------------------------------------
// lists of query results
// ---------------------------------------------------------------------------------------------------------------

// The counter of results stops growing once it is larger than QUERY_MOST. So it never overflows, but still shows the
// host that there are too many results.
static void answers_are_counted_up_to_a_limit(void** state)
{
	(void)state;
	Pools p = {0};
	open_pools(&p);
	QueryResult held[2] = {{.collidable = 1}, {.collidable = 2}};
	*p.query_plan = (QueryPlan){.room = 3};
	assert_int_equal(query_append(&p, 5, held, 2), 1);
	assert_int_equal(query_append(&p, 6, held, 2), 1);
	assert_int_equal(p.query_plan->found, 4);
	for (int k = 0; k < 3; ++k)
	{
		assert_int_equal(p.found[k].collidable, 1 + k % 2);
		assert_int_equal(p.found_query[k], 5 + k / 2);
	}
	p.query_plan->found = QUERY_MOST;
	assert_int_equal(query_append(&p, 7, held, 2), 1);
	for (int k = 0; k < 3; ++k)
		assert_int_equal(query_append(&p, 8, held, 1 + k % 2), 0);
	assert_int_equal(p.query_plan->found, QUERY_MOST + 2);
	close_pools(&p);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(boxes_follow_bodies),
	    cmocka_unit_test(rotations_are_exact_enough),
	    cmocka_unit_test(warm_start_equals_plain),
	    cmocka_unit_test(answers_are_counted_up_to_a_limit),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
