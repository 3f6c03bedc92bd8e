"""Where the dictionary has no word, or another reading than most texts mean: words, single characters, and what stands
around a character. Simplified characters only; a text in traditional ones is looked up in simplified."""

from __future__ import annotations

import re

WORDS = dict(
    re.findall(
        r"(\S+) ([a-z0-9 ]+[0-9])(?:,|\s*\Z)",
        """
        觉得 jue2 de5, 长得 zhang3 de5, 长大 zhang3 da4, 长高 zhang3 gao1, 长胖 zhang3 pang4, 长出 zhang3 chu1,
        长满 zhang3 man3, 长成 zhang3 cheng2, 长着 zhang3 zhe5, 长出来 zhang3 chu1 lai2, 拉长 la1 chang2,
        得分 de2 fen1, 得了 de2 le5, 不得了 bu4 de2 liao3, 变得 bian4 de5, 非得 fei1 dei3,
        总得 zong3 dei3, 只得 zhi3 de2, 使得 shi3 de5, 听得 ting1 de5, 弄得 nong4 de5,
        还书 huan2 shu1, 还书包 hai2 shu1 bao1, 还钱 huan2 qian2, 还款 huan2 kuan3,
        教书 jiao1 shu1, 教我 jiao1 wo3, 教你 jiao1 ni3, 教他 jiao1 ta1, 教她 jiao1 ta1, 教给 jiao1 gei3,
        教会 jiao1 hui4, 教课 jiao1 ke4, 请教 qing3 jiao4, 教育 jiao4 yu4, 教堂 jiao4 tang2, 教师 jiao4 shi1,
        教授 jiao4 shou4, 教练 jiao4 lian4, 教学 jiao4 xue2, 教室 jiao4 shi4, 教材 jiao4 cai2, 教训 jiao4 xun5,
        数到 shu3 dao4, 数数 shu3 shu4, 数一数 shu3 yi1 shu3, 数星星 shu3 xing1 xing5, 数钱 shu3 qian2,
        数不清 shu3 bu4 qing1, 重来 chong2 lai2, 重写 chong2 xie3, 重做 chong2 zuo4, 重建 chong2 jian4,
        重启 chong2 qi3, 重现 chong2 xian4, 重说 chong2 shuo1, 重读 chong2 du2, 重重的 zhong4 zhong4 de5,
        重重地 zhong4 zhong4 de5, 重庆 chong2 qing4, 重叠 chong2 die2,
        一行 yi1 hang2, 第一行 di4 yi1 hang2, 三行 san1 hang2, 一行行 yi1 hang2 hang2, 一行一行 yi1 hang2 yi1 hang2,
        一行人 yi1 xing2 ren2,
        行业 hang2 ye4, 行家 hang2 jia5, 行列 hang2 lie4, 银行 yin2 hang2, 睡个觉 shui4 ge4 jiao4,
        成为 cheng2 wei2, 称为 cheng1 wei2, 视为 shi4 wei2, 变为 bian4 wei2, 分为 fen1 wei2, 作为 zuo4 wei2,
        认为 ren4 wei2, 以为 yi3 wei2, 改为 gai3 wei2, 名为 ming2 wei2, 化为 hua4 wei2, 选为 xuan3 wei2,
        因为 yin1 wei4, 为了 wei4 le5, 倒是 dao4 shi4, 倒出 dao4 chu1, 倒车 dao4 che1, 倒茶 dao4 cha2,
        了解 liao3 jie3, 吃得了 chi1 de5 liao3, 吃不了 chi1 bu4 liao3, 办得了 ban4 de5 liao3,
        办不了 ban4 bu4 liao3, 走得了 zou3 de5 liao3, 去不了 qu4 bu4 liao3, 干嘛 gan4 ma2,
        睡着 shui4 zhao2, 睡不着 shui4 bu4 zhao2, 找着 zhao3 zhao2, 着急 zhao2 ji2, 着呢 zhe5 ne5,
        沉着 chen2 zhuo2, 执着 zhi2 zhuo2, 著名 zhu4 ming2, 著作 zhu4 zuo4, 著称 zhu4 cheng1, 显著 xian3 zhu4,
        名著 ming2 zhu4, 巨著 ju4 zhu4, 原著 yuan2 zhu4, 编著 bian1 zhu4, 专著 zhuan1 zhu4, 土著 tu3 zhu4,
        乾坤 qian2 kun1, 乾隆 qian2 long2, 瞭望 liao4 wang4,
        头发 tou2 fa5, 妈妈 ma1 ma5, 爸爸 ba4 ba5, 哥哥 ge1 ge5, 姐姐 jie3 jie5, 弟弟 di4 di5, 妹妹 mei4 mei5,
        爷爷 ye2 ye5, 奶奶 nai3 nai5, 叔叔 shu1 shu5, 星星 xing1 xing5, 谢谢 xie4 xie5, 朋友 peng2 you5,
        先生 xian1 sheng5, 学生 xue2 sheng5, 时候 shi2 hou5, 喜欢 xi3 huan5, 明白 ming2 bai5, 漂亮 piao4 liang5,
        衣服 yi1 fu5, 早上 zao3 shang5, 晚上 wan3 shang5, 名字 ming2 zi5, 认识 ren4 shi5, 告诉 gao4 su5,
        东西 dong1 xi5, 地方 di4 fang5, 关系 guan1 xi5, 舒服 shu1 fu5, 休息 xiu1 xi5, 太阳 tai4 yang5,
        月亮 yue4 liang5, 我们 wo3 men5, 你们 ni3 men5, 他们 ta1 men5, 她们 ta1 men5, 咱们 zan2 men5,
        哪里 na3 li5, 那里 na4 li5, 这里 zhe4 li5, 家里 jia1 li5, 豆腐 dou4 fu5, 葡萄 pu2 tao5, 清楚 qing1 chu5,
        一切 yi1 qie4, 万一 wan4 yi1, 统一 tong3 yi1, 唯一 wei2 yi1, 单一 dan1 yi1, 之一 zhi1 yi1, 专一 zhuan1 yi1,
        这儿 zhe4 er5, 那儿 na4 er5, 哪儿 na3 er5, 周一 zhou1 yi1, 星期一 xing1 qi1 yi1, 礼拜一 li3 bai4 yi1
        """,
    )
)
"""Words and their syllables: more than the dictionary's, or in place of its."""

SINGLES = {
    "长": "chang2",
    "長": "chang2",
    "乾": "gan1",
    "着": "zhe5",
    "著": "zhe5",
    "地": "di4",
    "得": "de5",
    "了": "le5",
}
SINGLES |= {"〇": "ling2", "诶": "ei2", "欸": "ei2", "呣": "m2", "为": "wei4", "為": "wei4"}
"""Characters that stand in no word, as most texts mean them."""

COUNTED = "[一二两三四五六七八九十百千几每这那半数0-9]"
AROUND = (
    ("行", f"(?<={COUNTED})行(?!人|为|动|走|不行|得)", "hang2"),
    ("只", f"(?<={COUNTED})只(?!是|能|有|要|会|好|不)", "zhi1"),
    (
        "地",
        "(?<=[^，。在到大土当本各满种扫着个片块整两外内此产原])地(?=[^，。、？！；：上下里的是和有在面方])",
        "de5",
    ),
    ("得", "(?<=[我你他她它们谁就总都也又可还])得(?=[^很多了不，。、？！；：])", "dei3"),
    ("得", "(?<![^，。、？！；：])得", "de2"),
    ("了", "(?<=[不得])了(?=[，。！？；吗呢吧啦]|$)", "liao3"),
    ("还", "还(?=[了给])", "huan2"),
    ("儿", "(?<=[花玩这那哪点事会味劲头块样口面边孩明今昨活歌鸟猫词伴空圈弯馅墩串份])儿(?![子女童科歌])", "er5"),
)
"""A character that stands in no word, what is around it, and its syllable then; the first that fits counts."""
