#pragma once

// Bodies that should rest, or slide straight down a slope: prints one CSV line for each quantity.
void PrintRest();
