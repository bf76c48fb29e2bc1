// SPDX-License-Identifier: MIT
// peer_validate.h -- scree_peers validate: makes the experiments of scree validate with both engines.
#ifndef PEER_VALIDATE_H
#define PEER_VALIDATE_H

// Reads the words after "validate" and runs the experiments. Returns an exit code. A result of Box2D beyond a limit is
// no failure, because the limits are meant for Scree.
int validate_peers(int count, char** words, const char* executable);

#endif
