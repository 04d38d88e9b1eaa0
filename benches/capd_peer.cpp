// A motion enclosed by CAPD, for capd_peers.py: capd_peer A1 A2 A3 r1 r2 r3 g1 g2 g3 l1 l2 l3 TIME ORDER TOLERANCE SET BOUND.
//
// Prints the time, the widest of gamma and omega then, the steps and the seconds of CPU time; it ends at TIME, where the width
// passes BOUND or where CAPD gives up. Numbers are read as the decimals that they are; SET is doubleton or tripleton.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <string>

#include "capd/capdlib.h"

using namespace capd;

static double processor_time() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return time.tv_sec + 1e-9 * time.tv_nsec;
}

template <class Set>
static void follow(ITimeMap& flow, Set set, double end, double bound) {
  const double begun = processor_time();
  double time = 0, width = 0;
  long steps = 0;
  flow.stopAfterStep(true);
  try {
    do {
      const IVector x = flow(interval(end), set);
      double widest = 0;
      for (int i = 0; i < 6; ++i) widest = std::max(widest, diam(x[i]).rightBound());
      if (!(widest <= bound)) break;
      time = flow.getCurrentTime().leftBound();
      width = widest;
      ++steps;
    } while (!flow.completed());
  } catch (const std::exception&) {
    // What was enclosed before stands.
  }
  std::printf("%.17g %.4g %ld %.4f\n", time, width, steps, processor_time() - begun);
}

int main(int count, char** text) {
  if (count != 18) return 2;
  const auto number = [&](int k) { return interval(text[k], text[k]); };
  IMap field("par:a1,a2,a3,u,v,w;var:x,y,z,p,q,s;fun:y*s-z*q,z*p-x*s,x*q-y*p,"
             "((a2-a3)*q*s-(y*w-z*v))/a1,((a3-a1)*s*p-(z*u-x*w))/a2,((a1-a2)*p*q-(x*v-y*u))/a3;");
  const char* parameters[] = {"a1", "a2", "a3", "u", "v", "w"};
  for (int i = 0; i < 6; ++i) field.setParameter(parameters[i], number(1 + i));
  IVector start(6);
  for (int i = 0; i < 3; ++i) start[i] = number(7 + i);
  const interval length = sqrt(start[0] * start[0] + start[1] * start[1] + start[2] * start[2]);
  for (int i = 0; i < 3; ++i) {
    start[i] = start[i] / length;
    start[3 + i] = number(10 + i) / number(1 + i);
  }
  IOdeSolver solver(field, std::atoi(text[14]));
  solver.setAbsoluteTolerance(std::atof(text[15]));
  solver.setRelativeTolerance(std::atof(text[15]));
  ITimeMap flow(solver);
  const double end = std::atof(text[13]), bound = std::atof(text[17]);
  if (std::string(text[16]) == "tripleton") follow(flow, C0TripletonSet(start), end, bound);
  else follow(flow, C0Rect2Set(start), end, bound);
}
