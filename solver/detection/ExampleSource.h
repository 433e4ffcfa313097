// solver/detection/ExampleSource.h - what kinds and severities are judged by: shipped examples, those of a file, or
// passages of the vehicle and track at hand, and the labels of the user.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/CaseDescription.h"
#include "core/Monitor.h"
#include "detection/Detect.h"
#include "detection/DetectionFiles.h"
#include "detection/Examples.h"

namespace squat::detection {

struct SourceOptions {
  std::optional<cases::CaseDescription> vehicle;  // whose passages are computed; none: general examples
  std::string vehicleName;                        // of that case
  std::string folder;                             // where its examples are kept
  std::string examplesFile;                       // in place of the shipped ones; empty: those
  std::string labelsFile;                         // empty: none
  std::string learnedFile;  // keepLearned() wrote it for earlier records of this train; with labels, it may be absent
  SeverityLimits limits;
  int jobs = 1;  // runs at once, of passages that are computed
};

struct ExampleSource {
  std::vector<Example> examples;
  JudgementOptions judgement;  // narrower for the vehicle at hand
  SizeModel sizes;             // of many vehicles
  std::vector<Example> own;    // passages of the records' own vehicle: of its case, of a table of one vehicle, labels
  std::string words;           // where they come from, and how many labels match no event
  AxleSides sides;             // by the shipped passages over defects on one rail
  std::size_t fromLabels = 0, ownFromLabels = 0;  // of `examples` and of `own`, at their ends, learned ones included
  std::vector<Example> learned;                   // from labels, earlier ones and these
};

// Passages of a vehicle are computed once for the typical speed of the records and kept as
// FOLDER/CASE-HASH.examples.csv. The labels are attached to the records' events. Nothing where that was cancelled.
// Throws as makeExamples(), readExamples() and readLabels().
std::optional<ExampleSource> exampleSource(const SourceOptions& options, std::vector<RecordDetection>& records,
                                           Monitor& monitor);

// Writes the labelled events that serve as examples, for the next records of the same train; no file where there are
// none. Throws FileError.
void keepLearned(const ExampleSource& source, const std::string& path);

// Judges the candidates of all records and combines their passes. With labels, a note says of how many other events
// they, or those of earlier records, changed kind or severity. Nothing where it was cancelled.
std::optional<DetectionReport> judged(std::vector<RecordDetection> records, const ExampleSource& source,
                                      const DetectOptions& options, Monitor& monitor);

}  // namespace squat::detection
