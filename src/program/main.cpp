#include "program/program.hpp"

int main(int argc, char** argv) { return groundgrid::program::run(argc, argv); }
