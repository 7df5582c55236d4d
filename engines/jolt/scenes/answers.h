#pragma once

// The scenes of tests/answers, at 240 steps a second: reads the launches that engines/ranking/scenes.py prints from the
// standard input, and prints the quantities of the reference answers and the time of a step as CSV.
void PrintAnswers();
