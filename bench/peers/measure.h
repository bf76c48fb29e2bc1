// SPDX-License-Identifier: MIT
// measure.h -- measures the overlaps, contacts and joint errors of poses, in the same way for all engines.
#ifndef MEASURE_H
#define MEASURE_H
#include "setup.h"

typedef struct // locked coordinates of a joint, by scree_coordinate
{
	bool locked[2];
	float target[2]; // m
} MeasureLock;

typedef struct
{
	scree_world* world; // Scree world with the bodies of the scene, at the poses of the engine
	scree_body* bodies;
	scree_velocity* still; // zero velocities, one per body
	int count;
	scree_pose* poses; // poses of the engine; the caller fills them before measuring

	int measured;      // number of measurements
	float penetration; // deepest overlap of all measurements, m
	double depths;     // sum over all measurements of the deepest overlap, m
	double contacts;   // sum over all measurements of the number of touching contacts
	float* height;     // height of each body at the first measurement, m
	int heights;       // number of entries of `height`
	float sunk;        // largest descent of a body from the first measurement to the last, m

	scree_joint* joints;
	scree_joint_state* states; // states of the joints at the last measurement
	MeasureLock* locks;
	int joint_count;
	float separation;    // largest distance of an anchor from its locked place in all measurements, m
	double gaps, gauged; // m: sum of these distances over all joints and measurements; number of distances
} Measure;

// Functions that return a bool return false after printing a sentence; the caller must call measure_close also after a
// failure.
bool measure_open(Measure* measure, const Setup* setup);
bool measure_change(Measure* measure, const Setup* setup, int64_t step); // makes the scene's changes before a step
bool measure_take(Measure* measure);                                     // adds the measures of `poses`
double measure_gap(const Measure* measure);                              // returns the mean distance, gaps / gauged, m
void measure_close(Measure* measure);

#endif
