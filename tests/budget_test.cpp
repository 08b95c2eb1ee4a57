// Budgets: how they are read, and what they say to a command's results.
#include "app/budget.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.h"

namespace gridscope {
namespace {

using Json = nlohmann::ordered_json;

const Json kResults = Json::parse(R"({
  "rays": 1000, "wrong": 25,
  "verdicts": {"hole": 10, "far": 15},
  "causes": {"refused": 20, "gate": 5},
  "references": {"tried": 400, "stored": 360, "refused": 40},
  "cells": {"occupied": 50, "saturated": 5, "histogram": [1, 2]},
  "scene": {"name": "hall", "triangles": 12}, "other": {"triangles": 13}, "holds": true, "empty": {"tried": 0, "refused": 0}
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
  EXPECT_NE(messageOf("scene.triangles>1%"), "") ;
}

}  // namespace
}  // namespace gridscope
