// SPDX-License-Identifier: MIT
// test_live.c -- checks on the CPU and on OpenCL that the time at which changes are uploaded makes no difference.
#include "support/make_bodies.h"
#include "tools/common/random_numbers.h"

#define MANY 60

typedef struct
{
	scree_world* world;
	scree_attribute attributes[6];
	scree_body bodies[MANY];
	uint64_t seed;
} Life;

static void be_born(Life* l, int k)
{
	scree_body_def def = scree_body_def_default();
	def.attribute = l->attributes[random_below(&l->seed, 6)];
	def.type = random_below(&l->seed, 4) ? SCREE_BODY_DYNAMIC : SCREE_BODY_KINEMATIC;
	def.disabled = random_below(&l->seed, 3) == 0;
	def.pose.position = (scree_vec){random_between(&l->seed, -6, 6), random_between(&l->seed, 0.5f, 9)};
	def.velocity = (scree_velocity){{random_between(&l->seed, -2, 2), random_between(&l->seed, -2, 2)},
	                                random_between(&l->seed, -2, 2)};
	l->bodies[k] = create_body(l->world, &def);
}

static void live(Life* l)
{
	scree_body body = l->bodies[random_below(&l->seed, MANY)];
	scree_collidable part = collidable_of(l->world, body);
	float x = random_between(&l->seed, -3, 3), y = random_between(&l->seed, -3, 3);
	scree_body_type type;
	OK(scree_body_get_type(l->world, body, &type));
	switch (random_below(&l->seed, 9))
	{
	case 0:
	case 1:
		OK(scree_body_set_enabled(l->world, body, random_below(&l->seed, 2)));
		break;
	case 2:
		OK(scree_collidable_set_attribute(l->world, part, l->attributes[random_below(&l->seed, 6)]));
		break;
	case 3:
		OK(scree_body_set_linear_velocity(l->world, body, (scree_vec){x, y}));
		break;
	case 4:
		OK(scree_body_set_angular_velocity(l->world, body, x));
		break;
	case 5:
		if (type == SCREE_BODY_KINEMATIC)
			OK(scree_body_set_target(l->world, body, pose_at(x, 3.0f + y, x)));
		break;
	case 6:
		OK(scree_body_apply_impulse(l->world, body, (scree_vec){0.1f * x, 0.1f * y}));
		OK(scree_body_apply_force(l->world, body, (scree_vec){x, y}));
		break;
	case 7:
		OK(scree_body_set_type(l->world, body, (scree_body_type)random_below(&l->seed, 3)));
		break;
	default:
		for (int k = 0; k < MANY; ++k)
			if (scree_body_equals(l->bodies[k], body))
			{
				OK(scree_body_destroy(l->world, body));
				be_born(l, k);
				break;
			}
	}
}

static void begin_life(Life* l)
{
	*l = (Life){.world = open_test_world(-10.0f), .seed = 4};
	add_floor(l->world);
	for (int k = 0; k < 6; ++k)
	{
		scree_attribute_def def = scree_attribute_def_default();
		def.friction = 0.2f * (float)k;
		if (k >= 3)
			def.shape = circle_shape(0.3f + 0.1f * (float)(k / 5));
		l->attributes[k] = add_attribute(l->world, &def);
	}
	for (int k = 0; k < MANY; ++k)
		be_born(l, k);
}

// Makes the same calls in two worlds. In one of the two it reads the hash and contacts after each call, which uploads
// the changes. After each step both worlds have the same hash.
static void reading_changes_nothing(void** state)
{
	(void)state;
	Life read, silent;
	begin_life(&read);
	begin_life(&silent);
	for (int k = 0; k < 100; ++k)
	{
		for (int i = 0; i < 12; ++i)
		{
			live(&read);
			live(&silent);
			hash_of(read.world);
			contacts_with(read.world, read.bodies[i]);
		}
		float dt = k % 7 == 3 ? 0.0f : STEP;
		OK(scree_world_step(read.world, dt, 2));
		OK(scree_world_step(silent.world, dt, 2));
		assert_true(hash_of(read.world) == hash_of(silent.world));
	}
	scree_world_destroy(read.world);
	scree_world_destroy(silent.world);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(reading_changes_nothing),
	};
	return RUN_ON_DEVICES(tests);
}
