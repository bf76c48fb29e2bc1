// SPDX-License-Identifier: MIT
// columns.c -- columns, weights on light boxes, card house, arch and pyramid stand, and sink little.
//
// Limits of sinking are the results of Box2D v3 (617d32a, sleep off). Where Scree always sank less than Box2D, they are
// the results of Scree.
#include "props.h"
#include <math.h>

#define MINUTE 3600 // number of steps

typedef struct
{
	double sank, leaned; // m: largest movement down, and largest movement sideways
	int body;            // index of the body that moved sideways the most
} Fall;

static Fall stand(Lab* lab, int first, int steps)
{
	Fall fall = {0};
	lab_step(lab, steps);
	lab_read(lab);
	for (int k = first; k < lab->count; ++k)
	{
		scree_vec start = lab->bodies[k].def.pose.position, end = lab->poses[k].position;
		double leaned = fabs((double)(end.x - start.x));
		fall.sank = larger(fall.sank, (double)(start.y - end.y));
		if (leaned > fall.leaned)
		{
			fall.leaned = leaned;
			fall.body = k - first;
		}
	}
	return fall;
}

// Takes steps, prints the largest movements of bodies down and sideways, and closes the lab.
static void print_fall(Validation* v, Lab* lab, int first, int steps, Limit limit, double sink, double lean)
{
	Fall fall = stand(lab, first, steps);
	row(v, "sank", fall.sank, "m", limit, sink);
	where(v, "body %d", fall.body);
	row(v, "moved sideways", fall.leaned, "m", limit, lean);
	lab_close(lab);
}

static Lab* open_with(Validation* v, int substeps, int* first)
{
	LabDef def = lab_def();
	def.substeps = substeps;
	Lab* lab = lab_open(v, &def);
	add_floor(lab, 50.0);
	*first = lab->count;
	return lab;
}

static void column(Validation* v, int count, int substeps, double jitter, Limit limit, double sink)
{
	int first;
	begin(v, "%d boxes x %d substeps%s", count, substeps, jitter > 0.0 ? " set down unevenly" : "");
	Lab* lab = open_with(v, substeps, &first);
	add_column(lab, count, 0.0, jitter);
	print_fall(v, lab, first, v->quick ? MINUTE / 3 : MINUTE, limit, sink, count < 100 ? 0.25 : 1.0);
}

static void weight(Validation* v, double density, Limit limit, double sink)
{
	int first;
	begin(v, "%g x weight on ten boxes", density);
	Lab* lab = open_with(v, LAB_SUBSTEPS, &first);
	add_column(lab, 10, 0.0, 0.0);
	scree_attribute_def top = box_of(0.5, 0.5);
	top.density = (float)density;
	lab_put(lab, SCREE_BODY_DYNAMIC, &top, 0.0f, 10.5f, 0.0f);
	print_fall(v, lab, first, v->quick ? MINUTE / 3 : MINUTE, limit, sink, 0.25);
}

// A column of boxes, rounded boxes, hexagons and lying capsules. Each body is at most 1 m wide.
static void mixed(Validation* v, int count)
{
	int first;
	begin(v, "%d bodies of four kinds", count);
	Lab* lab = open_with(v, LAB_SUBSTEPS, &first);
	scree_vec hexagon[6] = {{0.5f, 0.0f},  {0.3f, 0.25f},   {-0.3f, 0.25f},
	                        {-0.5f, 0.0f}, {-0.3f, -0.25f}, {0.3f, -0.25f}};
	scree_attribute_def kinds[4] = {box_of(0.5, 0.25), rounded_of(0.5, 0.25, 0.1), polygon_of(hexagon, 6),
	                                capsule_of(0.25, 0.25)};
	for (int k = 0; k < count; ++k)
		lab_put(lab, SCREE_BODY_DYNAMIC, &kinds[k % 4], 0.0f, 0.25f + 0.5f * (float)k, 0.0f);
	print_fall(v, lab, first, v->quick ? MINUTE / 3 : MINUTE, AT_MOST, 0.014, 0.01);
}

// Adds the card house of Box2D v3's sample CardHouse (Erin Catto), with its first card at x = `left`: pairs of leaning
// cards, with flat cards on them. Each card is displaced at random by up to `jitter`, m. Returns the last card.
static int add_card_house(Lab* lab, int levels, double left, double jitter, uint64_t* seed)
{
	const double half = 0.2, thick = 0.001, pitch = 0.175;
	const float angle = 0.436332313f; // 25 degrees
	scree_attribute_def card = box_of(thick, half);
	int last = 0;
	card.friction = 0.7f;
	lab->bodies[0].parts[0].surface.friction = 0.7f;
	for (int level = 0; level < levels; ++level)
	{
		double x = pitch * level, y = half - 0.02 + (2.0 * half - 0.03) * level;
		for (int k = 0; k < levels - level; ++k, x += 2.0 * pitch)
			for (int part = k < levels - level - 1 ? 0 : 1; part < 3; ++part)
			{
				double aside = jitter > 0.0 ? random_real(seed, -jitter, jitter) : 0.0,
				       above = jitter > 0.0 ? random_real(seed, -jitter, jitter) : 0.0;
				last = lab_put(lab, SCREE_BODY_DYNAMIC, &card,
				               (float)(left + x + (part == 0 ? 0.25 : pitch * (part - 1)) + aside),
				               (float)(y + (part == 0 ? half - 0.015 : 0.0) + above),
				               part == 0 ? 1.57079633f : (float)(2 * part - 3) * angle);
			}
	}
	return last;
}

static void card_house(Validation* v, int levels)
{
	int first;
	begin(v, "card house of %d levels", levels);
	Lab* lab = open_with(v, LAB_SUBSTEPS, &first);
	add_card_house(lab, levels, 0.0, 0.0, NULL);
	print_fall(v, lab, first, v->quick ? MINUTE / 3 : MINUTE, AT_MOST, 0.033, 0.0075);
}

// Card houses whose cards are displaced at random. Chance decides which houses fall, but hardly changes the number of
// houses that fall, which is limited.
static void card_houses(Validation* v, int levels, double jitter, int most)
{
	enum
	{
		HOUSES = 40
	};
	int first, top[HOUSES], fell = 0;
	begin(v, "%d card houses of %d levels, put down to %g mm", HOUSES, levels, 1e3 * jitter);
	Lab* lab = open_with(v, LAB_SUBSTEPS, &first);
	uint64_t seed = 1;
	for (int k = 0; k < HOUSES; ++k)
		top[k] = add_card_house(lab, levels, 2.4 * (k - HOUSES / 2), jitter, &seed);
	lab_step(lab, MINUTE / 6);
	lab_read(lab);
	for (int k = 0; k < HOUSES; ++k)
		fell += !(lab->poses[top[k]].position.y > lab->bodies[top[k]].def.pose.position.y - 0.1f);
	row(v, "fell in 10 s", fell, "", AT_MOST, most);
	lab_close(lab);
}

// An arch of wedge-shaped stones between two half circles, without mortar. Its two lowest stones lie on the floor.
static void arch(Validation* v, int stones)
{
	int first;
	begin(v, "arch of %d stones", stones);
	Lab* lab = open_with(v, LAB_SUBSTEPS, &first);
	const double inside = 4.0, outside = 5.5, pi = 3.14159265358979;
	for (int k = 0; k < stones; ++k)
	{
		double a = pi * k / stones, b = pi * (k + 1) / stones;
		scree_vec corners[4] = {{(float)(inside * cos(a)), (float)(inside * sin(a))},
		                        {(float)(outside * cos(a)), (float)(outside * sin(a))},
		                        {(float)(outside * cos(b)), (float)(outside * sin(b))},
		                        {(float)(inside * cos(b)), (float)(inside * sin(b))}};
		scree_attribute_def stone = polygon_of(corners, 4);
		lab_put(lab, SCREE_BODY_DYNAMIC, &stone, 0.0f, 0.0f, 0.0f);
	}
	print_fall(v, lab, first, v->quick ? MINUTE / 3 : MINUTE, AT_MOST, 0.017, 0.01);
}

static void pyramid(Validation* v, int base, double sink, double lean)
{
	int first;
	begin(v, "pyramid of base %d", base);
	Lab* lab = open_with(v, LAB_SUBSTEPS, &first);
	scree_attribute_def box = box_of(0.25, 0.25);
	for (int row = 0; row < base; ++row)
	{
		for (int k = 0; k < base - row; ++k)
			lab_put(lab, SCREE_BODY_DYNAMIC, &box, 0.55f * ((float)k - 0.5f * (float)(base - row - 1)),
			        0.25f + 0.5f * (float)row, 0.0f);
	}
	print_fall(v, lab, first, v->quick ? MINUTE / 3 : MINUTE, AT_MOST, sink, lean);
}

void columns_experiment(Validation* v)
{
	column(v, 20, 4, 0.0, AT_MOST, 0.135);
	weight(v, 100.0, AT_MOST, 0.709);
	pyramid(v, 10, 0.0033, 0.0015);
	card_house(v, 5);
	card_houses(v, 5, 1e-4, 2);
	card_houses(v, 5, 1e-3, 8);
	if (v->quick)
		return;
	column(v, 50, 4, 0.0, AT_MOST, 0.866);
	column(v, 100, 4, 0.0, AT_MOST, 3.5);
	column(v, 50, 8, 0.0, AT_MOST, 0.866);
	column(v, 100, 8, 0.0, AT_MOST, 3.5);
	column(v, 20, 4, 0.02, AT_MOST, 0.135);
	column(v, 50, 4, 0.02, SHOWN, 0.0);
	weight(v, 200.0, SHOWN, 0.0);
	weight(v, 1000.0, SHOWN, 0.0);
	mixed(v, 12);
	arch(v, 15);
	pyramid(v, 30, 0.03, 0.045);
}
