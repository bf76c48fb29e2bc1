// SPDX-License-Identifier: MIT
// peer_validate.h -- scree_peers validate: the experiments of scree validate, made with both engines.
#ifndef PEER_VALIDATE_H
#define PEER_VALIDATE_H

// Reads the words after "validate" and runs the experiments. Returns an exit code; a row of Box2D beyond its limit is no
// failure, for the limits are Scree's.
int validate_peers(int count, char** words, const char* executable);

#endif
