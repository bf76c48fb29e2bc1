// SPDX-License-Identifier: MIT
// make.h -- the state of a random program while it is made, and random numbers for its calls.
#ifndef MAKE_H
#define MAKE_H
#include "programs/program.h"
#include "tools/common/random_numbers.h"
#include <float.h>
#include <math.h>

#define MOST_KINEMATIC 8
#define MOST_BODIES    110 // maximum number of bodies at a time, so that thousands of programs run within minutes

typedef struct
{
	Program* program;
	uint64_t seed;
	int bodies, collidables, attributes, joints, paths; // next unused numbers of objects
	float kinematic[MOST_KINEMATIC]; // numbers of the last bodies that were created as kinematic or became kinematic
	int kinematics;
	int alive;     // approximate number of bodies
	float extreme; // share of extreme values among all values
	bool extras;   // has restitution, rolling resistance and tangent speeds
	bool moves;    // moves between devices, which takes as long as dozens of steps
	bool jointed;  // has joints
	bool railed;   // has paths
	bool reports;  // some collidables report events
	bool asks;     // has queries
	bool senses;   // some collidables are sensors
	bool fields;   // has fields
	bool sleeps;   // bodies may sleep
	bool saves;    // snapshots are taken and restored
	bool rules;    // has one-way platforms, materials, excluded pairs and contact approval
	// bytes of a fuzzer, which replace the random numbers; null: random numbers. After the last byte, all are 0.
	const uint8_t* bytes;
	size_t left;
} Maker;

// ---------------------------------------------------------------------------------------------------------------
// numbers
// ---------------------------------------------------------------------------------------------------------------

// Returns a number from the next bytes of the fuzzer, at most 4.
static inline uint32_t take(Maker* m, int count)
{
	uint32_t word = 0;
	for (; count > 0 && m->left > 0; --count, --m->left)
		word = word << 8 | *m->bytes++;
	return word;
}

static inline int below(Maker* m, int count)
{
	return m->bytes ? (int)(take(m, count > 256 ? 2 : 1) % (uint32_t)count) : random_below(&m->seed, count);
}

static inline bool chance(Maker* m, double share)
{
	return (m->bytes ? take(m, 1) / 256.0 : random_real(&m->seed, 0.0, 1.0)) < share;
}

// Returns a number from low to high. Half of the numbers are multiples of 1/8: short as text, and often equal.
static inline float between(Maker* m, float low, float high)
{
	float x = m->bytes ? low + (high - low) * (float)take(m, 2) / 65536.0f : random_between(&m->seed, low, high);
	return chance(m, 0.5) ? floorf(x * 8.0f) / 8.0f : x;
}

static inline float pick(Maker* m, const float* values, int count) { return values[below(m, count)]; }
#define PICK(m, ...) pick(m, (const float[]){__VA_ARGS__}, (int)(sizeof((const float[]){__VA_ARGS__}) / sizeof(float)))

// C leaves the order of two operands or arguments open. So an expression has one random number that is not an
// argument of another, and programs are the same for every compiler.

// Returns x or -x.
static inline float of_any_sign(Maker* m, float x) { return chance(m, 0.5) ? x : -x; }

// Returns x, or in 1 % of the calls x + excess, which is out of range.
static inline int rarely_beyond(Maker* m, int x, int excess) { return chance(m, 0.01) ? x + excess : x; }

// Returns any finite number, for forces.
static inline float amount(Maker* m, float usual)
{
	if (chance(m, m->extreme))
		return of_any_sign(m, PICK(m, 0.0f, 1e-45f, 3e-42f, FLT_MIN, 1e-30f, 1e-20f, 1e-10f, 1e6f, 1e10f, 1e15f, 1e19f,
		                           1e20f, 1e22f, 1e25f, 1e30f, 1e35f, 1e38f, FLT_MAX));
	if (chance(m, 0.1))
		return PICK(m, 0.0f, -0.0f);
	return between(m, -usual, usual);
}

// Returns a coordinate, speed or spin. The library must refuse values beyond 1e5.
static inline float bounded(Maker* m, float usual)
{
	if (chance(m, m->extreme))
		return of_any_sign(m, PICK(m, 0.0f, 1e-45f, 3e-42f, FLT_MIN, 1e-20f, 1e-6f, 20.0f * usual, 400.0f, 1000.0f,
		                           1e4f, 99999.0f, 1e5f, 1.00001e5f, INFINITY, NAN));
	if (chance(m, 0.1))
		return PICK(m, 0.0f, -0.0f);
	return between(m, -usual, usual);
}

// Returns a factor. The library must refuse negative factors.
static inline float factor(Maker* m, float most)
{
	if (chance(m, m->extreme))
		return PICK(m, 0.0f, -0.0f, 1e-45f, 1e-30f, 1e-10f, 1e3f, 1e10f, 1e20f, 1e30f, FLT_MAX, -1.0f);
	return between(m, 0.0f, most);
}

static inline float angle(Maker* m) { return PICK(m, 0.0f, 0.0f, between(m, -3.2f, 3.2f), 0.785398163f, 1.57079633f); }

// defined in make_wild.c: replaces an argument of a call by a wild value, or puts a call that forges a handle, if bytes of a
// fuzzer request it
void make_wild(Maker* m, Call* call);

static inline void put(Maker* m, Call call)
{
	if (m->bytes)
		make_wild(m, &call);
	program_add(m->program, call);
}

// Returns a number for a body; sometimes no body has this number.
static inline float any_body(Maker* m) { return (float)below(m, m->bodies + 1); }

// defined in make_attribute.c
float any_attribute(Maker* m);          // returns a number for an attribute; sometimes no attribute has this number
void set_surface(Maker* m, Call* call); // sets the arguments of SURFACE
void put_attribute(Maker* m);
void put_like(Maker* m);
void put_drop(Maker* m);
void put_material(Maker* m);

// defined in make_collidable.c
void set_filter(Maker* m, Call* call);
void set_reports(Maker* m, Call* call);
void set_sensor(Maker* m, Call* call);
void set_place(Maker* m, Call* call);
void put_collidable(Maker* m);
void put_own(Maker* m); // make_own.c

// defined in make_body.c
void put_body(Maker* m);
void put_bodies(Maker* m, int count);
void put_hub(Maker* m);
void put_floor(Maker* m);
void put_motion(Maker* m); // adds a call that moves bodies
void put_setting(Maker* m);
void put_destroy(Maker* m);

// defined in make_joint.c
void put_joint(Maker* m);
void put_joints(Maker* m, int count); // joins a row of bodies that the last call created
void put_joint_change(Maker* m);
void put_path(Maker* m); // adds or destroys a path

// defined in make_sleep.c
void set_sleep(Maker* m, Call* call);  // sets whether a world sleeps, and its threshold
void set_asleep(Maker* m, Call* call); // sets whether a new body sleeps, and its threshold
float step_length(Maker* m);           // returns a length of a step; a few of these steps last 0.5 s
void put_sleep(Maker* m);

// defined in make_field.c
void put_field(Maker* m);

#endif
