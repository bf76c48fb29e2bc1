// SPDX-License-Identifier: MIT
// constants.h -- declares functions that compute the constants of a step, and upload the list of kinematic bodies.
#ifndef CONSTANTS_H
#define CONSTANTS_H
#include "step/pipeline_state.h"

// Returns whether some body is, or was, so small that its contacts begin nearer than others.
bool step_small(const Pipeline* pipeline);

Step step_constants(const Pipeline* pipeline, const StepRequest* request);

// Returns the values of a step that depend on gravity, m/s^2. The gravity of the request is not used.
BayGravity step_gravity(const StepRequest* request, scree_vec gravity);

// Sets what joints have now: drives, springs, couplings, paths. The last step may have been before a joint got them.
void step_joints(Step* step, const Pipeline* pipeline);

// Sets the members that depend on the bays of a batch; zeros: there is none.
void step_bays(Step* step, const Bays* bays);

// Returns the number of contact slots of all live bays, rounded up to whole groups, and one more, which scans need.
int bays_contacts(const Pipeline* pipeline);

// Sets Step.place_capacity, the capacity for each kind of constraint. Must be called again after a pool has grown.
void step_places(Step* step, const Backend* b);

// Uploads the list of kinematic bodies if it changed and has at most KINEMATIC_FEW entries.
scree_status kinematics_upload(Pipeline* pipeline, const StepRequest* request);

#endif
