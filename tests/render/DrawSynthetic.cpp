// draw_synthetic FOLDER [MAP] - every figure of the made-up run, to be looked at, and the run as a result file.
#include <iostream>

#include "plots/Application.h"
#include "plots/Figures.h"
#include "render/SyntheticResult.h"
#include "results/ResultFile.h"

int main(int argc, char** argv) {
  squat::plots::ensureApplication(argc, argv);
  squat::plots::FigureRequest request;
  if (argc > 2) request.settings.colours = argv[2];
  std::vector<std::string> messages;
  for (const auto& path :
       squat::plots::renderFigures(squat::tests::syntheticResult(), argc > 1 ? argv[1] : ".", request, &messages))
    std::cout << path << '\n';
  squat::results::writeResult(std::string(argc > 1 ? argv[1] : ".") + "/synthetic.h5", squat::tests::syntheticResult());
  for (const auto& message : messages) std::cout << message << '\n';
}
