#pragma once

// Bodies that settle for a second, are thrown at 1 m/s with a spin, and come to rest: prints one CSV line for each.
void PrintThrows();
