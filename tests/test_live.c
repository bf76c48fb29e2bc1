// SPDX-License-Identifier: MIT
// test_live.c -- a world that lives on: it does not matter when the device hears of a change; on the CPU and on OpenCL.
#include "world_support.h"

#define MANY 60

typedef struct
{
	scree_world* world;
	scree_attribute attributes[6];
	scree_body bodies[MANY];
	uint64_t seed;
} Life;

static unsigned below(Life* l, unsigned count)
{
	l->seed = l->seed * 6364136223846793005u + 1442695040888963407u; // Donald Knuth
	return (unsigned)(l->seed >> 33) % count;
}

static float between(Life* l, float low, float high) { return low + (high - low) * (float)below(l, 65536) / 65536.0f; }

static void be_born(Life* l, int k)
{
	scree_body_def def = scree_body_def_default();
	def.attribute = l->attributes[below(l, 6)];
	def.type = below(l, 4) ? SCREE_BODY_DYNAMIC : SCREE_BODY_KINEMATIC;
	def.disabled = below(l, 3) == 0;
	def.pose.position = (scree_vec){between(l, -6, 6), between(l, 0.5f, 9)};
	def.velocity = (scree_velocity){{between(l, -2, 2), between(l, -2, 2)}, between(l, -2, 2)};
	assert_ok(scree_body_create(l->world, &def, &l->bodies[k]));
}

static void live(Life* l)
{
	scree_body body = l->bodies[below(l, MANY)];
	scree_collidable part = part_of(l->world, body);
	float x = between(l, -3, 3), y = between(l, -3, 3);
	scree_body_type type;
	assert_ok(scree_body_get_type(l->world, body, &type));
	switch (below(l, 9))
	{
	case 0:
	case 1:
		assert_ok(scree_body_set_enabled(l->world, body, below(l, 2)));
		break;
	case 2:
		assert_ok(scree_collidable_set_attribute(l->world, part, l->attributes[below(l, 6)]));
		break;
	case 3:
		assert_ok(scree_body_set_linear_velocity(l->world, body, (scree_vec){x, y}));
		break;
	case 4:
		assert_ok(scree_body_set_angular_velocity(l->world, body, x));
		break;
	case 5:
		if (type == SCREE_BODY_KINEMATIC)
			assert_ok(scree_body_set_target(l->world, body, pose_at(x, 3.0f + y, x)));
		break;
	case 6:
		assert_ok(scree_body_apply_impulse(l->world, body, (scree_vec){0.1f * x, 0.1f * y}));
		assert_ok(scree_body_apply_force(l->world, body, (scree_vec){x, y}));
		break;
	case 7:
		assert_ok(scree_body_set_type(l->world, body, (scree_body_type)below(l, 3)));
		break;
	default:
		for (int k = 0; k < MANY; ++k)
			if (scree_body_equals(l->bodies[k], body))
			{
				assert_ok(scree_body_destroy(l->world, body));
				be_born(l, k);
				break;
			}
	}
}

static void begin_life(Life* l)
{
	*l = (Life){.world = make_world(-10.0f), .seed = 4};
	add_ground(l->world);
	for (int k = 0; k < 6; ++k)
	{
		scree_attribute_def def = scree_attribute_def_default();
		def.friction = 0.2f * (float)k;
		if (k >= 3)
			assert_ok(scree_shape_make_circle((scree_vec){0, 0}, 0.3f + 0.1f * (float)(k / 5), &def.shape));
		assert_ok(scree_attribute_create(l->world, &def, &l->attributes[k]));
	}
	for (int k = 0; k < MANY; ++k)
		be_born(l, k);
}

// It does not matter when the device hears of a change: the same calls, with a look at the hash after each, and without.
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
		assert_ok(scree_world_step(read.world, dt, 2));
		assert_ok(scree_world_step(silent.world, dt, 2));
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
