// SPDX-License-Identifier: MIT
// test_sweep.c -- checks that fast bodies stop at the first surface on their path, and that surfaces beside the path
// have no effect.
#include "support/make_bodies.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SHAPES 4
#define PHASES 16 // number of start positions, spread over the motion of one step

// Returns a shape about 1 m wide, whose lowest point is 0.5 m below its origin.
static scree_shape shape_of(int kind)
{
	scree_shape shape = box_shape(0.5f, 0.5f);
	if (kind == 1)
		shape = circle_shape(0.5f);
	if (kind == 2)
		shape = capsule_shape(0.2f, 0.5f);
	if (kind == 3)
		shape = polygon_shape((scree_vec[]){{-0.4f, -0.4f}, {0.4f, -0.4f}, {0.0f, 0.3f}}, 3, 0.1f);
	return shape;
}

static scree_body add_bouncer(scree_world* world, scree_shape shape, float restitution, scree_vec from, scree_vec v)
{
	scree_attribute_def def = surface_of(shape);
	def.restitution = restitution;
	def.friction = 0.0f;
	scree_body body = add_body(world, SCREE_BODY_DYNAMIC, add_attribute(world, &def), from.x, from.y, 0.0f);
	throw_body(world, body, v.x, v.y, 0.0f);
	return body;
}

// v(t) = v0: a body that passes a stack at a small distance, above it, beside it or diagonally over its corner, keeps
// its velocity. The distance is 1 cm, or at least 7 mm at the corner.
static void passes_by(void** state)
{
	(void)state;
	for (int kind = 0; kind < SHAPES; ++kind)
		for (int phase = 0; phase < PHASES; ++phase)
			for (int variant = 0; variant < 3; ++variant)
			{
				scree_world* world = open_world(0.0f);
				for (int k = 0; k < 3; ++k)
					add_crate(world, SCREE_BODY_STATIC, 0.0f, (float)k - 2.5f);

				// variants: along the top, down the side, diagonally over the corner
				float back = 3.0f + (float)phase / PHASES, side = kind == 2 ? 0.7f : 0.5f;
				scree_vec from = {-back, 0.51f}, v = {60.0f, 0.0f};
				if (variant == 1)
				{
					from = (scree_vec){-0.5f - side - 0.01f, back};
					v = (scree_vec){0.0f, -60.0f};
				}
				if (variant == 2)
				{
					// the lower left corner of a box passes the corner (0.5, 0) of the stack at a distance of 7 mm;
					// other shapes pass farther away
					from = (scree_vec){0.51f + side - back, 0.5f + back};
					v = (scree_vec){40.0f, -40.0f};
				}
				scree_body body = add_bouncer(world, shape_of(kind), 0.0f, from, v);
				run_steps(world, 8);
				NEAR(velocity_of(world, body).linear.x, v.x, 1e-5);
				NEAR(velocity_of(world, body).linear.y, v.y, 1e-5);
				NEAR(velocity_of(world, body).angular, 0.0, 1e-5);
				scree_world_destroy(world);
			}
}

// A wall 5 cm thick stops bodies at 60 m/s, 1 m per step. Boxes, circles and capsules overlap it by at most the slop, 5
// mm; triangles by at most 8 cm.
static void thin_wall(void** state)
{
	(void)state;
	for (int kind = 0; kind < SHAPES; ++kind)
		for (int phase = 0; phase < PHASES; ++phase)
		{
			scree_world* world = open_world(0.0f);
			add_box(world, SCREE_BODY_STATIC, 0.025f, 5.0f, 0.0f, 0.0f);
			scree_body body = add_bouncer(world, shape_of(kind), 0.0f, (scree_vec){-3.0f - (float)phase / PHASES, 0.0f},
			                              (scree_vec){60.0f, 7.0f});
			float deepest = deepest_of(world, 10);
			assert_true(position_of(world, body).x < 0.0f);
			assert_true(deepest <
			            (kind == 3 ? 0.08f : 0.005f)); // a triangle hits with a corner and then spins by 1 rad per step
			scree_world_destroy(world);
		}
}

// v' = -e v for each restitution e (Newton's law of impact), at any time of impact within a step.
static void bounces(void** state)
{
	(void)state;
	for (int phase = 0; phase < PHASES; ++phase)
		for (int k = 1; k <= 4; ++k)
		{
			scree_world* world = open_world(0.0f);
			add_box(world, SCREE_BODY_STATIC, 0.5f, 5.0f, 0.0f, 0.0f);
			scree_body body = add_bouncer(world, circle_shape(0.5f), 0.25f * (float)k,
			                              (scree_vec){-3.0f - (float)phase / PHASES, 0.0f}, (scree_vec){60.0f, 0.0f});
			float deepest = deepest_of(world, 10);
			NEAR(velocity_of(world, body).linear.x, -15.0 * k, 0.01);
			assert_true(deepest < 0.005f);
			scree_world_destroy(world);
		}
}

// Two bodies of equal mass that meet head on with e = 1 exchange their velocities.
static void meets_head_on(void** state)
{
	(void)state;
	for (int phase = 0; phase < PHASES; ++phase)
	{
		scree_world* world = open_world(0.0f);
		float start = 2.0f + (float)phase / PHASES;
		scree_body a =
		    add_bouncer(world, circle_shape(0.5f), 1.0f, (scree_vec){-start, 0.0f}, (scree_vec){50.0f, 0.0f});
		scree_body b =
		    add_bouncer(world, circle_shape(0.5f), 1.0f, (scree_vec){start, 0.0f}, (scree_vec){-30.0f, 0.0f});
		run_steps(world, 10);
		NEAR(velocity_of(world, a).linear.x, -30.0, 0.01);
		NEAR(velocity_of(world, b).linear.x, 50.0, 0.01);
		scree_world_destroy(world);
	}
}

// A blade of 4 m turns at 10 rad/s, 1/6 rad per step. It pushes a body away without cutting into it.
static void blade(void** state)
{
	(void)state;
	for (int kind = 0; kind < SHAPES; ++kind)
		for (int phase = 0; phase < PHASES; ++phase)
		{
			scree_world* world = open_world(0.0f);
			float angle = 0.2f * (float)PI + 0.35f * (float)phase / PHASES;
			scree_body turning =
			    add_shape(world, SCREE_BODY_KINEMATIC, box_shape(2.0f, 0.1f), 0.0f, 0.0f, angle - 0.5f * (float)PI);
			throw_body(world, turning, 0.0f, 0.0f, 10.0f);
			scree_body body =
			    add_bouncer(world, shape_of(kind), 0.0f, (scree_vec){1.0f, 1.0f}, (scree_vec){0.0f, 0.0f});
			float deepest = deepest_of(world, 20);
			assert_true(deepest < 0.12f);
			scree_vec at = position_of(world, body);
			assert_true(hypotf(at.x - 1.0f, at.y - 1.0f) > 1.0f);
			scree_world_destroy(world);
		}
}

// A box slides without friction over the seams of a floor of slabs, and keeps its velocity: v(t) = v0.
static void seams(void** state)
{
	(void)state;
	for (int phase = 0; phase < PHASES; ++phase)
	{
		scree_world* world = open_world(-10.0f);
		for (int k = 0; k < 24; ++k)
			add_crate(world, SCREE_BODY_STATIC, (float)k, -0.5f);
		scree_body body = add_bouncer(world, shape_of(0), 0.0f, (scree_vec){0.53f + (float)phase / PHASES, 0.5f},
		                              (scree_vec){20.0f, 0.0f});
		run_steps(world, 55);
		NEAR(velocity_of(world, body).linear.x, 20.0, 0.01);
		NEAR(position_of(world, body).y, 0.5, 0.002);
		scree_world_destroy(world);
	}
}

#define DRUM_BOXES 100
#define DRUM_SHOTS 6
#define FAR_BODIES 12
#define DRUM_HALF  5.0f // m, from center to walls

typedef struct
{
	scree_world* world;
	scree_body drum, inside[DRUM_BOXES + DRUM_SHOTS], far[FAR_BODIES];
} Drum;

// Opens a world with a rotating drum of four walls. Inside are boxes and balls; the balls move at up to 90 m/s along x.
static Drum open_drum(void)
{
	Drum d = {.world = open_world(-10.0f)};
	scree_attribute_def wall = surface_of(box_shape(0.3f, DRUM_HALF + 0.6f)),
	                    crate = surface_of(box_shape(0.25f, 0.25f)), ball = surface_of(circle_shape(0.15f));
	scree_attribute walls = add_attribute(d.world, &wall), crates = add_attribute(d.world, &crate),
	                balls = add_attribute(d.world, &ball);
	scree_body_def def = scree_body_def_default();
	def.type = SCREE_BODY_KINEMATIC;
	def.velocity.angular = 2.0f;
	d.drum = create_body(d.world, &def);
	for (int k = 0; k < 4; ++k)
	{
		scree_collidable_def part = scree_collidable_def_default();
		part.body = d.drum;
		part.attribute = walls;
		part.pose.rotation = scree_rot_make(0.5f * (float)PI * (float)k);
		part.pose.position =
		    (scree_vec){(DRUM_HALF + 0.3f) * part.pose.rotation.c, (DRUM_HALF + 0.3f) * part.pose.rotation.s};
		OK(scree_collidable_create(d.world, &part, &(scree_collidable){0}));
	}
	for (int k = 0; k < DRUM_BOXES; ++k)
		d.inside[k] = add_body(d.world, SCREE_BODY_DYNAMIC, crates, 0.6f * (float)(k % 10) - 2.7f,
		                       0.6f * (float)(k / 10) - 2.7f, 0.0f);
	for (int k = 0; k < DRUM_SHOTS; ++k)
	{
		d.inside[DRUM_BOXES + k] = add_body(d.world, SCREE_BODY_DYNAMIC, balls, 0.4f * (float)k - 1.0f, 3.4f, 0.0f);
		OK(scree_body_set_velocity(d.world, d.inside[DRUM_BOXES + k],
		                           (scree_velocity){{90.0f - 36.0f * (float)k, 60.0f}, 0.0f}));
	}
	return d;
}

// Continuous collision compares a path with each kinematic body if there are few, and searches the trees if there are
// many. One world has few, the other has many far away, which become kinematic and static in turn. Bodies in the drum
// must have the same motion in both worlds, bit for bit, and must not leave the drum.
static void drum(void** state)
{
	(void)state;
	Drum few = open_drum(), many = open_drum();
	for (int k = 0; k < FAR_BODIES; ++k)
		many.far[k] = add_box(many.world, SCREE_BODY_KINEMATIC, 0.5f, 0.5f, 1000.0f + 3.0f * (float)k, 0.0f);
	for (int step = 0, far = FAR_BODIES; step < 240; ++step)
	{
		for (int k = 0; k < far && step % 7 == 0; ++k)
			OK(scree_body_set_type(many.world, many.far[k],
			                       (step + k) % 3 == 0 ? SCREE_BODY_STATIC : SCREE_BODY_KINEMATIC));
		while (step == 100 && far > FAR_BODIES / 2)
			OK(scree_body_destroy(many.world, many.far[--far]));
		run_steps(few.world, 1);
		run_steps(many.world, 1);
		for (int k = 0; k < DRUM_BOXES + DRUM_SHOTS; ++k)
		{
			scree_pose a, b;
			a = pose_of(few.world, few.inside[k]);
			b = pose_of(many.world, many.inside[k]);
			assert_memory_equal(&a, &b, sizeof a);
			assert_true(hypotf(a.position.x, a.position.y) < 1.4143f * DRUM_HALF);
		}
	}
	scree_world_destroy(few.world);
	scree_world_destroy(many.world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(passes_by),     cmocka_unit_test(thin_wall), cmocka_unit_test(bounces),
	    cmocka_unit_test(meets_head_on), cmocka_unit_test(blade),     cmocka_unit_test(seams),
	    cmocka_unit_test(drum),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
