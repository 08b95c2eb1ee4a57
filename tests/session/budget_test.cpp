// Budgets: how they are read, and what they say to a command's results.
#include "app/session/budget.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/error.h"

namespace gridscope {
namespace {

using Json = nlohmann::ordered_json;

const Json kResults = Json::parse(R"({
  "rays": 1000, "wrong": 25,
  "verdicts": {"hole": 10, "far": 15},
  "causes": {"refused": 20, "gate": 5},
  "references": {"tried": 400, "stored": 360, "refused": 40},
  "cells": {"occupied": 50, "saturated": 5, "histogram": [1, 2]},
  "scene": {"name": "hall", "triangles": 12}, "other": {"triangles": 13}, "holds": true, "empty": {"tried": 0, "refused": 0},
  "confirmed": {"gate": [3, 1, 5]}, "confirmedShare": 0.985, "control": {"confirmed": 2, "total": 8, "share": 0.25},
  "worstCells": [{"rays": 7, "tried": 30, "refused": 6}], "stages": [], "uncounted": {"stored": 3, "lost": null}
})");

bool isBroken(const std::string& text) { return judgeBudget(parseBudget(text), kResults).broken; }

std::string messageOf(const std::string& text) {
  try {
    judgeBudget(parseBudget(text), kResults);
  } catch (const Error& error) {
    EXPECT_EQ(error.exitCode(), kExitBadInput);
    return error.what();
  }
  return "";
}

TEST(Budget, IsAFigureARelationAndANumber) {
  const Budget budget = parseBudget(" cells.saturated >= 5e2 ");
  EXPECT_EQ(budget.key, "cells.saturated");
  EXPECT_EQ(budget.relation, Budget::Relation::atLeast);
  EXPECT_EQ(budget.limit, 500.0);
  EXPECT_FALSE(budget.percent);
  EXPECT_TRUE(parseBudget("wrong>1%").percent);
  EXPECT_EQ(parseBudget("wrong<1").relation, Budget::Relation::below);
  EXPECT_EQ(parseBudget("wrong<=-1.5").limit, -1.5);
}

TEST(Budget, RefusesWhatItCannotRead) {
  for (const char* text : {"", "wrong", ">1", "wrong>", "wrong=1", "wrong>x", "wrong>1%%", "wrong>>1", "wrong>=%"})
    EXPECT_NE(messageOf(text).find("--fail-if"), std::string::npos) << text;
}

TEST(Budget, ComparesWithEachRelation) {
  EXPECT_TRUE(isBroken("wrong>24"));
  EXPECT_FALSE(isBroken("wrong>25"));
  EXPECT_TRUE(isBroken("wrong>=25"));
  EXPECT_TRUE(isBroken("wrong<26"));
  EXPECT_FALSE(isBroken("wrong<25"));
  EXPECT_TRUE(isBroken("wrong<=25"));
  EXPECT_TRUE(isBroken("holds<=1"));
}

TEST(Budget, TakesPercentOfRaysOfReferencesTriedAndOfOccupiedCells) {
  EXPECT_EQ(judgeBudget(parseBudget("wrong>1%"), kResults).line, "wrong>1%: wrong is 25 of 1,000 rays (2.5 %)");
  EXPECT_TRUE(isBroken("wrong>2.4%"));
  EXPECT_FALSE(isBroken("wrong>2.5%"));
  EXPECT_TRUE(isBroken("references.refused>=10%"));
  EXPECT_FALSE(isBroken("references.refused>10%"));
  EXPECT_TRUE(isBroken("cells.saturated>9.9%"));
  EXPECT_TRUE(isBroken("causes.refused>1.9%"));
  EXPECT_FALSE(isBroken("causes.refused>2%"));
  EXPECT_FALSE(isBroken("empty.refused>0%")) << "nothing of nothing";
}

TEST(Budget, FindsAFigureByTheEndOfItsName) {
  EXPECT_EQ(judgeBudget(parseBudget("saturated>500"), kResults).line, "saturated>500: cells.saturated is 5");
  EXPECT_EQ(judgeBudget(parseBudget("hole>1"), kResults).line, "hole>1: verdicts.hole is 10");
}

TEST(Budget, NamesTheNearestFiguresOfAnUnknownOneAndAllOfAnAmbiguousOne) {
  EXPECT_NE(messageOf("saturatd>1").find("the nearest are cells.saturated"), std::string::npos) << messageOf("saturatd>1");
  EXPECT_NE(messageOf("triangles>1").find("scene.triangles or other.triangles"), std::string::npos);
  EXPECT_NE(messageOf("name>1").find("no figure"), std::string::npos) << "a text is no figure";
  EXPECT_NE(messageOf("scene.triangles>1%"), "");
}

TEST(Budget, ReachesIntoListsByPlace) {
  EXPECT_EQ(judgeBudget(parseBudget("confirmed.gate.0<3"), kResults).line, "confirmed.gate.0<3: confirmed.gate.0 is 3");
  EXPECT_TRUE(isBroken("worstCells.0.rays>=7"));
  EXPECT_NE(messageOf("confirmed.gate>1").find("confirmed.gate.0 to confirmed.gate.2"), std::string::npos) << messageOf("confirmed.gate>1");
  EXPECT_NE(messageOf("confirmed.gate.3>1").find("no figure"), std::string::npos);
  EXPECT_NE(messageOf("worstCells.x.rays>1").find("no figure"), std::string::npos);
}

TEST(Budget, TakesPercentOfProofsOfSharesAndOfWhatTheGroupHolds) {
  EXPECT_EQ(judgeBudget(parseBudget("confirmed.gate.0<90%"), kResults).line,
            "confirmed.gate.0<90%: confirmed.gate.0 is 3 of 5 rays of that cause (60 %)");
  EXPECT_EQ(judgeBudget(parseBudget("confirmedShare<99%"), kResults).line, "confirmedShare<99%: confirmedShare is 0.985 (98.5 %)");
  EXPECT_FALSE(isBroken("control.share>25%"));
  EXPECT_TRUE(isBroken("control.share>24%"));
  EXPECT_TRUE(isBroken("control.confirmed>=25%"));
  EXPECT_TRUE(isBroken("worstCells.0.rays>0.69%"));
  EXPECT_FALSE(isBroken("worstCells.0.rays>0.7%"));
  EXPECT_TRUE(isBroken("worstCells.0.refused>=20%"));
}

TEST(Budget, ShortNamesOfCausesAndVerdictsAreFoundAndNeedTheTruthAlone) {
  Json without = kResults;
  without.erase("empty");
  EXPECT_TRUE(judgeBudget(parseBudget("gate>4"), without).broken);
  EXPECT_TRUE(judgeBudget(parseBudget("refused>39"), without).broken) << "of the references, not of the causes";
  for (const char* key : {"wrong", "verdicts", "causes"}) without.erase(key);
  EXPECT_TRUE(
      haveFigures({parseBudget("refused>1"), parseBudget("cells.saturated>1"), parseBudget("stages.0.invariants.sum.count>0")}, without));
  for (const char* text : {"gate>1", "wrong>1", "hole>1", "causes.refused>1"})
    EXPECT_FALSE(haveFigures({parseBudget(text)}, without)) << text;
}

TEST(Budget, AFigureWithoutAValueIsSaidToHaveNone) {
  EXPECT_NE(messageOf("lost>1").find("uncounted.lost has no value here"), std::string::npos) << messageOf("lost>1");
}

TEST(Budget, IsCheckedAgainstTheShapeOfTheResultsBeforeThereAreAny) {
  EXPECT_NO_THROW(checkBudgets({parseBudget("wrong>1%"), parseBudget("stages.4.count>1")}, kResults));
  EXPECT_THROW(checkBudgets({parseBudget("wrongs>1")}, kResults), Error);
  EXPECT_THROW(checkBudgets({parseBudget("scene.triangles>1%")}, kResults), Error);
  EXPECT_THROW(checkBudgets({parseBudget("confirmed.gate.7>1")}, kResults), Error);
}

TEST(Budget, OfSeveralFramesIsBrokenByAnyOfThemAndNamesTheFirst) {
  std::vector<Json> frames(4, kResults);
  frames[1]["wrong"] = 31;
  const Budget budget = parseBudget("wrong>30");
  EXPECT_EQ(judgeFrames(budget, frames).line, "frame 1: wrong>30: wrong is 31");
  EXPECT_TRUE(judgeFrames(budget, frames).broken);
  frames[3]["wrong"] = 40;
  EXPECT_EQ(judgeFrames(budget, frames).line, "frame 1: wrong>30: wrong is 31; likewise 1 more of 4 frames");
  EXPECT_FALSE(judgeFrames(parseBudget("wrong>40"), frames).broken);
  EXPECT_EQ(judgeFrames(parseBudget("rays>1"), frames).line, "rays>1: rays is 1,000") << "the same in all: no frame's own";
}

}  // namespace
}  // namespace gridscope
