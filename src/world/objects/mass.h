// SPDX-License-Identifier: MIT
// mass.h -- the mass of a body, computed from its collidables.
#ifndef MASS_H
#define MASS_H
#include "world/world.h"

// Returns the mass that the user set, or the sum over the collidables. A dynamic body without either has 1 kg and
// cannot turn; other types have mass 0.
scree_mass mass_of_body(const scree_world* world, int body);

// Returns HostBody.mass with its inertia, even if the inertia is not yet stored there.
scree_mass mass_now(const scree_world* world, int body);

// Return the inverse mass, 1/kg, and the inverse inertia, 1/(kg m^2). The inverse of 0 is 0; the inverse inertia is
// also 0 if rotation is locked.
float mass_inverse(const HostBody* host);
float mass_inverse_inertia(const HostBody* host);

// Return the row of a body in the pool continuous_body, and the command that writes it. May lower
// Pipeline.continuous_way and raise continuous_reach.
ContinuousBody continuous_row(scree_world* world, int body);
Command continuous_command(scree_world* world, int body);

// Records an anchor of a joint, in the body's frame. The caller has reserved memory for a command.
void mass_anchor(scree_world* world, int body, scree_vec anchor);

// Updates the mass after a collidable of a body became a sensor, or solid; -1 for no body. The caller has reserved
// memory for a command.
void mass_touches(scree_world* world, int body);

// Sets the mass of a body on the host and on the device. The caller has reserved memory for two commands.
void mass_set(scree_world* world, int body, scree_mass mass);

// Does the same for a mass set by the user. The mass is kept, even while the body is of another type, until its
// collidables change.
void mass_own(scree_world* world, int body, scree_mass mass);

// Recomputes the mass of each dynamic body in the list, once per body, and sends the ContinuousBody of the others; -1
// means no body. gained: the bodies only got more collidables. Then the next mass_settle computes the inertia,
// with a command for which edits_reserve always leaves memory. Otherwise a body whose many collidables are created one
// by one would sum over all of them each time, in a time that grows with the square of their number.
void masses_update(scree_world* world, const int* bodies, int count, bool gained);

// Computes the inertia that is pending. Called before an upload, and before anything that reads it or a command that
// depends on it.
void mass_settle(scree_world* world);

// Drops the sums for a body, because its mass is set in another way or it is about to be destroyed.
void mass_forget(scree_world* world, int body);

#endif
