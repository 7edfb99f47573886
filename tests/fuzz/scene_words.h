// Every word of the scene format: names of keys, and values that a key allows, in quotes.
#pragma once

#include <string>
#include <vector>

std::vector<std::string> scene_words();
