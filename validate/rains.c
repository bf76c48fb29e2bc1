// SPDX-License-Identifier: MIT
// rains.c -- many ragdolls per second fall 40 m onto floors: measures the gaps of their joints while ragdolls land on
// each other.
#include "bones.h"
#include "experiment_support.h"
#include "props.h"
#include <math.h>
#include <stdlib.h>

#define ROW_HEIGHT 45.0 // m: distance between floors
#define DROP       40.0 // m: height above a floor from which ragdolls fall
#define GROUP      5    // ragdolls in a column on each floor
#define EVERY      8    // number of steps between columns
#define COLUMN     6.25 // m: distance between columns
#define TILE       0.5  // m: size of a tile of a floor
#define LANDING    171  // number of steps in which a body falls 40 m

static void add_ragdoll(Lab* lab, scree_vec feet, int group)
{
	int first = lab->count;
	for (int k = 0; k < BONES; ++k)
	{
		EnginePart parts[BONE_PARTS];
		scree_body_def def = bone_def(k, feet, group);
		lab_add(lab, &def, parts, bone_parts(k, group, parts));
		if (bone_parent(k) < 0)
			continue;
		scree_joint_def joint = bone_joint(k);
		lab_join(lab, &joint, first + bone_parent(k), first + k);
	}
}

static void add_tiles(Lab* lab, double span, double height)
{
	int tiles = (int)(span / TILE) + 1;
	scree_body_def def = scree_body_def_default();
	def.type = SCREE_BODY_STATIC;
	EnginePart* parts = require_memory(malloc((size_t)tiles * sizeof *parts));
	for (int k = 0; k < tiles; ++k)
	{
		scree_pose at = {{(float)(TILE * k - 0.5 * span), (float)height}, {1.0f, 0.0f}};
		parts[k] = (EnginePart){box_of(0.5 * TILE, 0.5 * TILE), scree_filter_default()};
		lab->validation->broken |=
		    scree_shape_transform(&parts[k].surface.shape, at, &parts[k].surface.shape) != SCREE_OK;
	}
	lab_add(lab, &def, parts, tiles);
	free(parts);
}

// Simulates the rain of Box2D's benchmarks, without removing ragdolls: columns of ragdolls fall onto each of several
// floors. If all fall from the same height, 25 ragdolls land at the same time. In Box2D all 25 landings are alike. In
// Scree the constraints of the ragdolls have different colors, so the widest gap is the maximum of 25 different
// landings. Therefore a second rain adds a random height of at most `spread`, m, to each ragdoll. The spread is about the
// distance that a ragdoll falls in the step before it lands.
static void rain(Validation* v, int columns, int rows, double spread)
{
	begin(v, "%d ragdolls that fall onto %d floors from %s", columns * rows * GROUP, rows,
	      spread > 0.0 ? "40 to 40.5 m" : "40 m");
	LabDef def = lab_def();
	Lab* lab = lab_open(v, &def);
	double span = COLUMN * columns;
	for (int row = 0; row < rows; ++row)
		add_tiles(lab, span, ROW_HEIGHT * row);
	int last = EVERY * columns + LANDING, steps = last - LANDING;
	double* gaps = require_memory(malloc((size_t)steps * sizeof *gaps));
	double widest = 0.0;
	uint64_t seed = 1;
	for (int step = 0; step < last; ++step)
	{
		int column = step / EVERY;
		for (int k = 0; k < rows * GROUP && step % EVERY == 0 && column < columns; ++k)
		{
			double x = COLUMN * (column + 0.5) - 0.5 * span + 0.5 * (k % GROUP);
			double y = DROP + ROW_HEIGHT * (k / GROUP) + random_real(&seed, 0.0, spread);
			add_ragdoll(lab, (scree_vec){(float)x, (float)y}, k % GROUP + 1);
		}
		lab_step(lab, 1);
		lab_read(lab);
		double gap = lab_gap(lab);
		widest = larger(widest, gap);
		if (step >= LANDING)
			gaps[step - LANDING] = gap;
	}
	row(v, "median of the widest gaps", 1e3 * upper_median_of(gaps, steps), "mm", AT_MOST, spread > 0.0 ? 60.0 : 40.0);
	row(v, "widest gap", 1e3 * widest, "mm", AT_MOST, spread > 0.0 ? 250.0 : 140.0);
	free(gaps);
	lab_close(lab);
}

void rains_experiment(Validation* v)
{
	rain(v, v->quick ? 4 : 40, v->quick ? 1 : 5, 0.0);
	rain(v, v->quick ? 4 : 40, v->quick ? 1 : 5, 0.5);
}
