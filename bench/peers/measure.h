// SPDX-License-Identifier: MIT
// measure.h -- measures overlaps, contacts and joints of poses, in the same way for all engines.
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
	scree_world* world; // with the bodies of the scene, at the poses of the engine
	scree_body* bodies;
	scree_velocity* still; // zeros
	int count;
	scree_pose* poses; // poses of the engine; the caller fills them before measuring

	int measured;
	float penetration; // deepest so far, m
	double depths;     // sum of the deepest of each measurement, m
	double contacts;   // sum of the touching contacts of each
	float* height;     // height of each body at the first measurement, m
	int heights;
	float sunk; // largest distance that one of them has sunk since, m

	scree_joint* joints;
	scree_joint_state* states; // at the last measurement
	MeasureLock* locks;
	int joint_count;
	float separation;    // largest distance of an anchor from where it is held, so far, m
	double gaps, gauged; // sum of all these distances, m; number of them
} Measure;

// These return false after printing a sentence. The caller closes the measure also then.
bool measure_open(Measure* measure, const Setup* setup);
bool measure_change(Measure* measure, const Setup* setup, int64_t step); // follows bodies that come and go
bool measure_take(Measure* measure);
double measure_gap(const Measure* measure); // the mean of these distances, m
void measure_close(Measure* measure);

#endif
