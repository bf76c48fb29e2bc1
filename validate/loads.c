// SPDX-License-Identifier: MIT
// loads.c -- light bodies under heavy bodies, and bodies that are pressed together, come to rest with any number of
// substeps and any stiffness.
#include "props.h"
#include <math.h>
#include <stdarg.h>

#define SECONDS 20

typedef struct
{
	int substeps;
	double hertz; // Hz: stiffness of contacts; 0: the default of the engine
} Setting;

static const Setting settings[] = {{4, 0.0},  {1, 0.0},  {2, 0.0},   {8, 0.0},
                                   {12, 0.0}, {4, 30.0}, {4, 240.0}, {12, 240.0}};

// Begins a case whose name includes the setting. Returns the lab of the case. gravity: m/s^2, downwards.
__attribute__((format(printf, 4, 5))) static Lab* open_case(Validation* v, const Setting* setting, double gravity,
                                                            const char* format, ...)
{
	char name[64];
	va_list arguments;
	va_start(arguments, format);
	vsnprintf(name, sizeof name, format, arguments);
	va_end(arguments);
	if (setting->hertz > 0.0)
		begin(v, "%s: %d substeps and %g Hz", name, setting->substeps, setting->hertz);
	else
		begin(v, "%s: %d substeps", name, setting->substeps);
	LabDef def = lab_def();
	def.substeps = setting->substeps;
	def.contact_hertz = (float)setting->hertz;
	def.gravity.y = (float)-gravity;
	return lab_open(v, &def);
}

// Takes steps for SECONDS, s. Returns the largest speed of any body in the last second, m/s.
static double settle(Lab* lab)
{
	double fastest = 0.0;
	lab_step(lab, (SECONDS - 1) * 60);
	for (int n = 0; n < 60; ++n)
	{
		lab_step(lab, 1);
		lab_read(lab);
		fastest = larger(fastest, lab_fastest(lab, NULL));
	}
	return fastest;
}

// A box falls from 2 m on a pyramid of nine rows, which is ten boxes wide. ratio: mass of this box divided by the
// mass of each other box.
static void pyramid(Validation* v, double ratio, const Setting* setting)
{
	Lab* lab = open_case(v, setting, 10.0, "pyramid of nine rows under a box of %g times the mass", ratio);
	add_floor(lab, 100.0);
	scree_attribute_def box = box_of(1.0, 1.0), heavy = box;
	heavy.density = (float)ratio;
	int last = 0;
	for (int width = 10, row = 0; width > 0; --width, ++row)
		for (int k = 0; k < width; ++k)
			last = lab_put(lab, SCREE_BODY_DYNAMIC, width > 1 ? &box : &heavy, (float)(2 * k - width),
			               (float)(1 + 2 * row + (width > 1 ? 0 : 2)), 0.0f);
	double fastest = settle(lab);
	// with one substep a box of 300 times the mass of the others breaks through the pyramid, as in Box2D
	bool holds = ratio <= 100.0 || setting->substeps > 1;
	row(v, "sank", 19.0 - (double)lab->poses[last].position.y, "m", holds ? AT_MOST : SHOWN, 1.0);
	row(v, "fastest in the last second", fastest, "m/s", AT_MOST, 0.01);
	lab_close(lab);
}

// A cart stands on the floor: a heavy box on two wheels of 1.6 kg each.
static void cart(Validation* v, double mass, const Setting* setting)
{
	Lab* lab = open_case(v, setting, 10.0, "cart of %g kg on wheels of 1.6 kg", mass);
	add_floor(lab, 100.0);
	scree_attribute_def body = box_of(1.5, 0.25), wheel = circle_of(0.5);
	body.density = (float)(mass / 1.5);
	wheel.density = 2.0f;
	int chassis = lab_put(lab, SCREE_BODY_DYNAMIC, &body, 0.0f, 0.5f, 0.0f);
	for (int side = -1; side <= 1; side += 2)
	{
		int round = lab_put(lab, SCREE_BODY_DYNAMIC, &wheel, (float)side, 0.5f, 0.0f);
		scree_joint_def hinge = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
		hinge.frame_a.position = (scree_vec){(float)side, 0.0f};
		lab_join(lab, &hinge, chassis, round);
	}
	double fastest = settle(lab);
	row(v, "widest gap", 1e3 * lab_gap(lab), "mm", AT_MOST, 20.0);
	row(v, "fastest in the last second", fastest, "m/s", AT_MOST, 0.01);
	lab_close(lab);
}

// A cart of 1,000 kg falls 1.75 m on wheels with a radius of 10 cm, at a gravity of 22 m/s^2 (after the sample Cart of
// Erin Catto's Box2D v3). The impact drives joints and contacts apart; their correction must not throw the cart up
// again.
static void falling_cart(Validation* v, const Setting* setting)
{
	Lab* lab = open_case(v, setting, 22.0, "cart of 1000 kg that falls on wheels of 1.6 kg");
	add_floor(lab, 100.0);
	scree_attribute_def body = box_of(1.0, 0.25), wheel = circle_of(0.1);
	body.density = 1000.0f;
	wheel.density = 50.0f;
	wheel.rolling_resistance = 0.02f;
	int chassis = lab_put(lab, SCREE_BODY_DYNAMIC, &body, 0.0f, 2.25f, 0.0f);
	for (int side = -1; side <= 1; side += 2)
	{
		int round = lab_put(lab, SCREE_BODY_DYNAMIC, &wheel, 0.9f * (float)side, 1.85f, 0.0f);
		scree_joint_def hinge = scree_joint_def_make(SCREE_JOINT_REVOLUTE);
		hinge.frame_a.position = (scree_vec){0.9f * (float)side, -0.4f};
		lab_join(lab, &hinge, chassis, round);
	}
	double high = 0.0;
	lab_step(lab, 60);
	for (int n = 0; n < 120; ++n)
	{
		lab_step(lab, 1);
		lab_read(lab);
		high = larger(high, (double)lab->poses[chassis].position.y);
	}
	double fastest = settle(lab);
	row(v, "highest after the first second", high, "m", AT_MOST, 0.6);
	row(v, "widest gap", 1e3 * lab_gap(lab), "mm", AT_MOST, 25.0);
	row(v, "fastest in the last second", fastest, "m/s", AT_MOST, 0.01);
	lab_close(lab);
}

// 625 disks of 1 m, with a total area of 491 m^2, are pressed together in a smaller room without gravity.
static void press(Validation* v, double half, const Setting* setting)
{
	Lab* lab = open_case(v, setting, 0.0, "625 disks of 1 m in a room of %g m", 2.0 * half);
	scree_attribute_def side = box_of(1.0, half + 2.0), disk = circle_of(0.5);
	for (int k = 0; k < 4; ++k)
	{
		double angle = 0.5 * 3.14159265358979 * k;
		lab_put(lab, SCREE_BODY_STATIC, &side, (float)((half + 1.0) * cos(angle)), (float)((half + 1.0) * sin(angle)),
		        (float)angle);
	}
	for (int k = 0; k < 625; ++k)
		lab_put(lab, SCREE_BODY_DYNAMIC, &disk, (float)(2.0 * half / 25.0 * (k % 25 - 12)),
		        (float)(2.0 * half / 25.0 * (k / 25 - 12) + 0.01 * (k % 3)), 0.0f);
	double fastest = settle(lab);
	row(v, "deepest overlap", 1e3 * lab_overlap(lab, NULL), "mm", SHOWN, 0.0);
	row(v, "fastest in the last second", fastest, "m/s", AT_MOST, 0.01);
	lab_close(lab);
}

void loads_experiment(Validation* v)
{
	int count = v->quick ? 3 : (int)(sizeof settings / sizeof *settings);
	for (int k = 0; k < count; ++k)
	{
		pyramid(v, 100.0, &settings[k]);
		pyramid(v, 300.0, &settings[k]);
		cart(v, 500.0, &settings[k]);
		cart(v, 1000.0, &settings[k]);
		falling_cart(v, &settings[k]);
		if (!v->quick)
			press(v, 10.0, &settings[k]);
		if (!v->quick)
			press(v, 9.0, &settings[k]);
	}
}
