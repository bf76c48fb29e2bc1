// SPDX-License-Identifier: MIT
// mutate_recording.h -- changes a recording (docs/design/recording.md) at random, and corrects the digests of its records.
#ifndef MUTATE_RECORDING_H
#define MUTATE_RECORDING_H
#include <stddef.h>
#include <stdint.h>

// Writes a recording with the digests that its records should have, those of snapshots included. Bytes behind the last whole
// record are left out. Returns the new size, at most `most`; 0 if the bytes do not begin with the header of a recording of
// this version, or if there is no room.
size_t recording_seal(const uint8_t* bytes, size_t size, uint8_t* sealed, size_t most);

// Changes bytes in place, and returns the new size: values or the number of a record, the chunks of a snapshot (mutate_chunks),
// records that are left out, repeated or exchanged. Returns 0 if the bytes are no recording. size, most: present and largest
// number of bytes.
size_t mutate_recording(uint8_t* bytes, size_t size, size_t most, uint64_t seed);

#endif
