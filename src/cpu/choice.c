// SPDX-License-Identifier: MIT
// choice.c -- whether the workers share a solve, or one worker does it alone; measured.
#include "cpu/cpu.h"
#include "platform/processor.h"
#include <limits.h>

// A solve with more items per run than this is always shared.
#define ALWAYS_SHARED 2048
// The slower way is measured again after so many solves, times the square of the ratio of the times.
#define REST 64
// limit of that ratio, because a busy machine can make one way seem slow
#define MOST_SLOWER 4.0
// Solves in a row by a way that is measured. The fastest one but the first counts: any may be interrupted, and in the first one other
// workers may have to wake.
#define TURN 4
// turns in which the two ways alternate at first
#define FIRST_TURNS 4

// Counts what a solve cost that was done as the choice says, and decides about the next one. A cost higher than the last may be due to an
// interruption, so it is averaged in with a weight of a quarter. The other way is measured again at times, less often the slower it was.
static void count_cost(Choice* c, double cost)
{
	bool first = c->turns < FIRST_TURNS, measures = first || c->tries;
	c->least = !measures || c->tried <= 1 || cost < c->least ? cost : c->least;
	if (measures && ++c->tried < TURN)
		return;
	double* known = &c->cost[c->shares];
	*known = *known > 0 && c->least > *known ? 0.75 * *known + 0.25 * c->least : c->least;
	c->tried = 0;
	c->turns += first;
	if (c->tries)
	{
		double slower = c->cost[c->shares] / c->cost[!c->shares];
		slower = slower < MOST_SLOWER ? slower : MOST_SLOWER;
		c->rest = slower > 1 ? (int)(REST * slower * slower) : REST;
	}
	c->tries = !measures && --c->rest < 0;
	c->shares = c->turns < FIRST_TURNS ? c->turns % 2 == 0 : (c->cost[1] < c->cost[0]) != c->tries;
}

void cpu_work_solve(Cpu* cpu, const Run* runs, int count, double items, double chains)
{
	Choice* c = &cpu->choice;
	double mean = items / count;
	bool open = mean + chains / count >= SOLVE_GRAIN && mean <= ALWAYS_SHARED;
	double begin = processor_milliseconds();
	cpu->shares = open ? c->shares : mean > ALWAYS_SHARED;
	cpu_work(cpu, runs, count, cpu->shares ? SOLVE_GRAIN : INT_MAX);
	if (open)
		count_cost(c, (processor_milliseconds() - begin) / items);
}
