// SPDX-License-Identifier: MIT
// fill_rows.c -- writes values at the limits of what a batch accepts to the rows of its inputs.
#include "mirror/mirrored.h"
#include <float.h>
#include <math.h>

// Returns zeros, denormals, large values and usual ones.
static float any_number(uint64_t* dice, float large)
{
	const float values[] = {0.0f, -0.0f, 1e-40f, -1e-42f, large, -large};
	int k = random_below(dice, 8);
	return k < 6 ? values[k] : random_between(dice, -3.0f, 3.0f);
}

static void fill_vec(uint64_t* dice, float* row)
{
	row[0] = any_number(dice, rarely(dice, 6, FLT_MAX, 50.0f));
	row[1] = any_number(dice, rarely(dice, 6, 1e20f, 50.0f));
}

static void fill_number(uint64_t* dice, float* row) { row[0] = any_number(dice, rarely(dice, 6, FLT_MAX, 50.0f)); }

static void fill_velocity(uint64_t* dice, float* row)
{
	row[0] = any_number(dice, rarely(dice, 6, 1e5f, 5.0f));
	row[1] = any_number(dice, 5.0f);
	row[2] = any_number(dice, rarely(dice, 6, 1e5f, 5.0f));
}

static void fill_pose(uint64_t* dice, float* row)
{
	scree_rot rotation = random_rot(dice);
	float scale = rarely(dice, 4, 1.0004f, 1.0f); // nearly a rotation
	row[0] = rarely(dice, 8, 1e5f, any_number(dice, 1.0f));
	row[1] = any_number(dice, 1.0f);
	bool straight = one_in(dice, 4);
	row[2] = straight ? 1.0f : rotation.c * scale;
	row[3] = straight ? -0.0f : rotation.s * scale;
}

static void fill_speed(uint64_t* dice, float* row) { row[0] = any_number(dice, rarely(dice, 4, 1e5f, 5.0f)); }

static void fill_limit(uint64_t* dice, float* row)
{
	float limit = fabsf(any_number(dice, rarely(dice, 4, FLT_MAX, 50.0f)));
	row[0] = rarely(dice, 6, -0.0f, limit);
}

static void fill_gravity(uint64_t* dice, float* row)
{
	row[0] = any_number(dice, rarely(dice, 6, 1e6f, 10.0f));
	row[1] = any_number(dice, rarely(dice, 10, FLT_MAX, 10.0f));
}

static void fill_mass(uint64_t* dice, float* row)
{
	float heavy = rarely(dice, 4, 1e6f, random_between(dice, 0.1f, 5.0f));
	row[0] = rarely(dice, 4, 1e-15f, heavy);
	row[1] = rarely(dice, 3, 0.0f, random_between(dice, 0.01f, 3.0f));
	row[2] = rarely(dice, 2, 0.0f, random_between(dice, -1.0f, 1.0f));
	row[3] = rarely(dice, 2, 0.0f, random_between(dice, -1.0f, 1.0f));
}

static void fill_surface(uint64_t* dice, float* row)
{
	float friction = fabsf(any_number(dice, rarely(dice, 3, 1e6f, 1.0f)));
	row[0] = rarely(dice, 6, -0.0f, friction);
	row[1] = rarely(dice, 2, 0.0f, fabsf(any_number(dice, 1.0f)));
	row[2] = fabsf(any_number(dice, 1.0f));
	row[3] = any_number(dice, rarely(dice, 4, 1e5f, 3.0f));
}

static void fill_switch(uint64_t* dice, float* row)
{
	float off = rarely(dice, 3, -0.0f, 0.0f);
	row[0] = rarely(dice, 2, 1.0f, off);
}

static void (*const fills[])(uint64_t* dice, float* row) = {
#define INPUT(kind, object, columns, turn, fill, act) [kind] = fill,
#define OUTPUT(kind, object, columns, read)
#include "mirror/channel_kinds.def"
#undef INPUT
#undef OUTPUT
};

// Rows of 0 are no poses and no masses.
static bool must_fill(scree_channel_kind kind, const float* row)
{
	bool pose = kind == SCREE_INPUT_POSE || kind == SCREE_INPUT_TARGET;
	return (pose && row[2] == 0.0f && row[3] == 0.0f) || (kind == SCREE_INPUT_MASS && row[0] == 0.0f);
}

void fill_rows(Mirror* m, scree_channels list)
{
	const List* l = m->lists + list;
	float* row = l->rows;
	for (int w = 0; w < m->worlds; ++w)
		for (int k = 0; k < l->count; row += channel_columns_of(l->channels + k++))
		{
			scree_channel_kind kind = l->channels[k].kind;
			if (one_in(&m->dice, 2) || must_fill(kind, row)) // others keep their values
				fills[kind](&m->dice, row);
		}
}
