// SPDX-License-Identifier: MIT
// fuzz_api.c -- fuzz target: bytes are a program of calls, which runs on two worlds.
//
// The second world is also read, moved and restored between the calls. Calls have wild values and forged handles. Statuses,
// results and hashes of both worlds must be equal, and the state after each step must be finite and consistent
// (tests/programs/pair.c).
#include "fuzz/fuzz.h"
#include "programs/program.h"
#include <stdlib.h>
#include <string.h>

#define MOST_CALLS 80

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
	static const Place places[2] = {{.device = "cpu", .threads = 1, .lanes = 1},
	                                {.device = "cpu", .threads = 1, .lanes = 1, .reads = true}};
	static Pair pair;
	static Program program;
	if (size < 2)
		return 0;
	fuzz_limit_memory(SIZE_MAX); // a lack of memory in one of the worlds would be a difference
	if (!pair.names[0])
		pair_open(&pair, places);
	pair.first_read = bytes[0] % READ_CHOICES;
	program_make_from(&program, bytes + 1, size - 1, MOST_CALLS);
	if (getenv("SCREE_SHOW"))
		program_write(&program, stdout);
	const Outcome outcome = pair_run(&pair, &program, NULL);
	FUZZ_CHECK(!outcome.differs, "call %d: %s", outcome.call, outcome.sentence);
	fuzz_accepted += outcome.steps > 0;
	pair_forget(&pair);
	FUZZ_CHECK(scree_memory() == 0, "%zu bytes of memory are not released", scree_memory());
	return 0;
}
