// SPDX-License-Identifier: MIT
// figure.h -- what a figure's CSV holds: columns, and the names in them.
#ifndef FIGURE_H
#define FIGURE_H

// Columns of stages: the paper's, its copies over the bus among them, then ours. What a pipeline does not have is 0.
#define FIGURE_STAGES(X) \
	X(to_device)         \
	X(from_device)       \
	X(integrate)         \
	X(transform)         \
	X(detect)            \
	X(resolve)           \
	X(broad_phase)       \
	X(narrow_phase)      \
	X(color)             \
	X(solve)             \
	X(finalize)

#define FIGURE_STAGE_ID(name) FIGURE_STAGE_##name,
typedef enum
{
	FIGURE_STAGES(FIGURE_STAGE_ID) FIGURE_STAGE_COUNT
} FigureStage;

extern const char* const figure_stages[FIGURE_STAGE_COUNT];

// Scenes and pipelines in the order in which they are measured and drawn.
#define FIGURE_SCENES    2
#define FIGURE_PIPELINES 2
#define FIGURE_PLACES    3
extern const char* const figure_scenes[FIGURE_SCENES];       // drift, pyramids
extern const char* const figure_pipelines[FIGURE_PIPELINES]; // paper, scree

typedef enum // where a pipeline runs
{
	ON_ONE_THREAD,
	ON_THREADS, // more than one; the paper's pipeline has no such curve
	ON_OPENCL,
} FigurePlace;

// Draws a CSV that figure5_command or figure6_command wrote, number 5 or 6, as SVG and PNG beside it, and prints the
// crossovers of figure 5. Returns an exit code; without gnuplot it says that nothing is drawn, and all is well.
int plot_figure(const char* csv, int number);

#endif
