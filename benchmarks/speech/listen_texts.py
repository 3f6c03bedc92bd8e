"""Texts that the recogniser of mouth shapes is trained and measured on: everyday sentences, written for it."""

from __future__ import annotations

TRAINED: dict[str, str] = {
    "en-us": """The boy put both of his muddy boots by the big door.
Who knows where the moon goes when we cannot see it?
My father bought a small farm far beyond the harbor.
She sells warm bread, jam and butter at the market every Monday.
A famous woman from Maine wrote about maps for fifty months.
Keep the green bottle; the blue one is broken.
We were moving too slowly through the narrow wood.
Imagine a house of glass above the open water.
Do you believe that people remember the first movie they watched?
Thirty thieves thought they had thrilled the throne.
It rained in the evening, so everybody stayed at home and played cards.
Please choose a chair, the show is about to begin.
The old clock on the wall has stopped at half past four.
Very few of our visitors have ever found the cave.
Hot coffee and apple pie were all that Bob wanted.
How now, said the cow, looking down at the town.
Bring your umbrella, because the weather might change by noon.
The judge asked whether the young man had used the phone.
Our team won by a point, and the crowd went home happy.
Father and mother argued about the color of the new car.
You should move the wooden box before somebody falls over it.
Maybe a bumblebee bumped into the lamp above the bed.
I would rather walk along the river than wait for a bus.
Zebras and giraffes were grazing near the edge of the forest.""",
    "cmn": """今天早上我们一起去公园跑步。
妈妈买了八个苹果和四瓶牛奶。
北方的冬天很冷,南方的夏天很热。
他慢慢地把门打开,看见外面下雨了。
我的朋友在学校教音乐和数学。
请问,去火车站怎么走?
老师告诉我们明天不用上课。
这本书比那本书有意思得多。
爸爸每天晚上都喝一杯红茶。
飞机飞过高山,飞过大海。
奶奶做的包子又大又好吃。
如果你有时间,就到我家来玩吧。
秋天到了,树叶一片一片地落下来。
我不明白他为什么突然不说话。
小猫跑到桌子下面去睡觉了。
医生说他需要多喝水,多休息。
我们坐船游览了美丽的湖。
冰箱里面没有鸡蛋,也没有面包。
他写字写得很快,可是不太清楚。
警察帮助老人找到了自己的女儿。
中午我跟同事去饭馆吃饺子。
那个穿绿色毛衣的女孩是我妹妹。
春天的风轻轻地吹着河边的柳树。
图书馆八点开门,晚上九点关门。""",
    "de": """Der kleine Junge baut eine Burg aus Sand am Ufer.
Meine Mutter möchte im Sommer über die Berge wandern.
Plötzlich hörten wir ein Geräusch aus dem Wohnzimmer.
Fünf Frauen fuhren früh mit dem Zug nach Bremen.
Der Bäcker backt am Abend Brot für die ganze Stadt.
Ob es morgen schön wird, weiß auch der Nachbar nicht.""",
    "fr-fr": """Le petit garçon a perdu son bonnet dans la boue.
Une bonne soupe bien chaude nous attend à la maison.
Ma mère achète du beurre et des pommes au marché.
Tu peux ouvrir la fenêtre, il fait beau aujourd'hui.
Le boulanger vend du pain blanc depuis vingt ans.
Nous voulons voir le vieux pont avant la nuit.""",
    "es": """Mi abuela prepara una sopa muy buena con pan y tomate.
El niño busca su zapato debajo de la cama.
Mañana vamos a caminar por el bosque con los amigos.
Un hombre viejo vivía solo en una casa blanca.
¿Puedes ayudarme a mover este mueble, por favor?
La luna ilumina el agua tranquila de la bahía.""",
    "it": """La mamma compra il pane e il burro al mercato.
Domani andiamo a trovare gli amici in montagna.
Un uomo buono aiuta sempre i suoi vicini.
Il bambino ha perso la palla blu nel giardino.
Questa zuppa è troppo calda, aspettiamo un poco.
Vorrei vedere il fiume prima che faccia buio.""",
    "pt": """O menino comprou um bolo bom para a mãe.
Amanhã vamos passear na praia com os amigos.
Um homem velho mora sozinho naquela casa branca.
Você pode abrir a janela, por favor?
A lua ilumina a água calma do mar.
Meu pai gosta muito de pão com manteiga.""",
    "nl": """De kleine jongen bouwt een boot van papier.
Mijn moeder koopt brood en boter op de markt.
Morgen gaan we met vrienden naar het bos.
Er woont een oude man in dat witte huis.
Kun je het raam openen, het is hier warm.
De maan schijnt mooi over het water.""",
    "sv": """Den lille pojken bygger en båt av papper.
Min mamma köper bröd och smör på torget.
I morgon går vi ut i skogen med våra vänner.
En gammal man bor ensam i det vita huset.
Kan du öppna fönstret, det är så varmt här?
Månen lyser vackert över vattnet.""",
    "pl": """Mały chłopiec buduje zamek z piasku na plaży.
Moja mama kupuje chleb i masło na rynku.
Jutro pójdziemy z przyjaciółmi do lasu.
Stary człowiek mieszka sam w białym domu.
Czy możesz otworzyć okno, bo tu jest gorąco?
Księżyc pięknie świeci nad wodą.""",
    "ru": """Маленький мальчик строит замок из песка.
Моя мама покупает хлеб и масло на рынке.
Завтра мы пойдём с друзьями гулять по лесу.
Один старый человек живёт в большом белом доме.
Можешь открыть окно, здесь очень жарко?
Луна красиво освещает тёмную воду.""",
    "cs": """Malý chlapec staví hrad z písku u moře.
Moje maminka kupuje chleba a máslo na trhu.
Zítra půjdeme s přáteli na procházku do lesa.
Starý pán bydlí sám v bílém domě.
Můžeš otevřít okno, je tady horko?
Měsíc krásně svítí nad vodou.""",
    "tr": """Küçük çocuk kumsalda bir kale yapıyor.
Annem pazardan ekmek ve tereyağı aldı.
Yarın arkadaşlarla ormanda yürüyeceğiz.
Yaşlı bir adam o beyaz evde yalnız oturuyor.
Pencereyi açabilir misin, burası çok sıcak?
Ay suyun üstünde güzel parlıyor.""",
    "fi": """Pieni poika rakentaa hiekkalinnaa rannalla.
Äitini ostaa leipää ja voita torilta.
Huomenna menemme ystävien kanssa metsään.
Vanha mies asuu yksin valkoisessa talossa.
Voitko avata ikkunan, täällä on kuuma?
Kuu valaisee kauniisti tummaa vettä.""",
    "hu": """A kisfiú homokvárat épít a tó partján.
Anyám kenyeret és vajat vesz a piacon.
Holnap a barátokkal az erdőbe megyünk.
Egy öreg ember egyedül él a fehér házban.
Ki tudod nyitni az ablakot, mert meleg van?
A hold szépen ragyog a víz fölött.""",
    "ja": """ちいさなおとこのこが、うみでおしろをつくっています。
ははは、いちばで、ぱんとばたーをかいました。
あしたはともだちともりをあるきます。
まどをあけてもいいですか、ここはとてもあついです。
つきがみずのうえでうつくしくひかっています。
おじいさんは、しろいいえにひとりですんでいます。""",
    "ko": """작은 아이가 바다에서 모래성을 만들고 있어요.
어머니는 시장에서 빵과 버터를 샀습니다.
내일 우리는 친구들과 숲에 갈 거예요.
할아버지는 하얀 집에서 혼자 사십니다.
창문을 열어 주실 수 있어요, 여기는 너무 더워요.
달이 물 위에서 아름답게 빛나고 있습니다.""",
    "hi": """छोटा लड़का रेत का एक महल बना रहा है।
मेरी माँ बाज़ार से रोटी और मक्खन लाती है।
कल हम दोस्तों के साथ जंगल में घूमने जाएँगे।
एक बूढ़ा आदमी उस सफ़ेद घर में अकेला रहता है।
क्या तुम खिड़की खोल सकते हो, यहाँ बहुत गर्मी है?
चाँद पानी के ऊपर बहुत सुंदर चमक रहा है।""",
    "ar": """الولد الصغير يبني قلعة من الرمل.
أمي تشتري الخبز والزبدة من السوق.
غدا نذهب مع الأصدقاء إلى الغابة.
رجل كبير يسكن وحده في البيت الأبيض.
هل يمكنك أن تفتح الباب من فضلك؟
القمر جميل فوق الماء.""",
    "el": """Το μικρό αγόρι φτιάχνει ένα κάστρο από άμμο.
Η μητέρα μου αγοράζει ψωμί και βούτυρο στην αγορά.
Αύριο θα πάμε με τους φίλους στο δάσος.
Ένας παππούς μένει μόνος στο άσπρο σπίτι.
Μπορείς να ανοίξεις το παράθυρο, κάνει ζέστη;
Το φεγγάρι φωτίζει όμορφα το νερό.""",
    "vi": """Cậu bé nhỏ đang xây một lâu đài bằng cát.
Mẹ tôi mua bánh mì và bơ ở chợ.
Ngày mai chúng tôi đi vào rừng với bạn bè.
Một ông già sống một mình trong ngôi nhà trắng.
Bạn có thể mở cửa sổ không, ở đây nóng quá?
Mặt trăng chiếu sáng đẹp trên mặt nước.""",
    "sw": """Mtoto mdogo anajenga nyumba ya mchanga pwani.
Mama yangu ananunua mkate na siagi sokoni.
Kesho tutakwenda msituni pamoja na marafiki.
Mzee mmoja anaishi peke yake katika nyumba nyeupe.
Unaweza kufungua dirisha, hapa kuna joto sana?
Mwezi unaangaza vizuri juu ya maji.""",
}
"""Language and its sentences, one a line."""

MEASURED: dict[str, str] = {
    "en-us": """Mother made a pot of soup for the whole family.
The painter opened a window and looked over the valley.
What would happen if everyone spoke at the same time?
A brown fox and a lazy dog became good friends.
You may borrow my new book about boats and ships.
The museum is closed today, but the park is open.
Five brave firemen saved the cat from the burning barn.
Two hours later the moon rose over the mountain.
I hope the postman will bring a letter from Paul.
Nobody knew how to move the enormous piano.
Could you move a bit, so that we all have room?
The farmer's wife bought a pair of warm brown shoes.""",
    "cmn": """我家门口有一棵很大的苹果树。
爷爷喜欢坐在河边看报纸。
昨天下午我在商店买了一双白色的鞋。
你们什么时候放假回北京?
服务员,请给我一碗米饭和一盘青菜。
天上的月亮像一个大大的圆盘。
孩子们在操场上快乐地打篮球。
我觉得学习汉语非常有用。
他把电脑放在办公室的桌子上了。
外婆从乡下带来了许多新鲜的蔬菜。
明年春天我们要搬到一个新房子。
不要怕,慢慢说,我们都在听。""",
}
"""Sentences that nothing was trained on."""

MORE: dict[str, str] = {
    "en-us": """You knew who it was as soon as you moved into the room.
The blue balloon flew over the roof of the school.
Would you please put the cookbook in the good bag?
Bob bought a big bottle of apple juice for supper.
Everybody in the family wore a warm wool coat.
My mom made plum jam and pumpkin pie for Pam.
We could not remember whose shoes were on the floor.
Paul and Barbara always walk home along the water.
Far above the farm a large hawk was circling.
The shop on the corner sells lamps, pots and pans.
Use a smooth spoon to move the soup to the bowl.
Two new students asked a few useful questions.
He hopes to sell his old boat before October.
They saw both of us leave the office before four.
Few people understood the beautiful music.
The rude goose chased a poodle through the pool.
Apples and bananas are cheaper than plums in March.
I think it is time to bring them back home.
Put the wooden hook where your father can look for it.
Perhaps the captain will stop at the harbor for an hour.
Whenever we pass the bakery, we buy brown bread.
A calm palm tree stood behind the car park.
The poor boy lost his voice and could not shout.
Move over, or you will miss the bus to Boston.
She has seen seventeen sheep sleeping near the stream.
What a wonderful view of the woods from up here!
Our cousin grew up in a small village by the ocean.
Nothing but rumors came from the empty room.
Did the doctor tell you to avoid coffee and alcohol?
Please compare both maps before you plan a trip.
Huge waves broke over the bow of the slow ship.
I'm supposed to be at home by half past five.
The judge will choose the winner of the tune.
A group of young women drew pictures of a moose.
Harvard professors often argue about the problem.
Open your mouth and show me your bottom tooth.
Fresh fruit and vegetables keep the family healthy.
Wash the window, mop the floor and polish the lamp.
Those roads go over the border and on to Mexico.
You two should do whatever you choose to do.""",
    "it": """Il gatto dorme sotto il tavolo della cucina.
Ogni giovedì mio zio porta il giornale alla nonna.
Che cosa facciamo questa sera dopo la scuola?
Il pesce fresco costa meno al porto che in città.
Gli uccelli volano verso il sud quando arriva il freddo.
Sul muro bianco c'era un grande orologio di legno.
La figlia del medico studia musica e filosofia.
Chiudi la porta, per piacere, entra troppa aria.
Nel bosco abbiamo visto una volpe e due lupi.
Giuseppe vuole una bicicletta nuova per il viaggio.
Poche persone sapevano dove fosse la chiave.
Un ombrello rosso galleggiava sull'acqua scura.""",
    "fi": """Kissa nukkuu keittiön pöydän alla.
Setä tuo mummolle lehden joka torstai.
Mitä me teemme tänä iltana koulun jälkeen?
Tuore kala on halvempaa satamassa kuin kaupungissa.
Linnut lentävät etelään, kun talvi tulee.
Valkoisella seinällä oli suuri puinen kello.
Lääkärin tytär opiskelee musiikkia ja filosofiaa.
Sulje ovi, ole hyvä, täällä vetää.
Metsässä näimme ketun ja kaksi sutta.
Pekka haluaa uuden polkupyörän matkaa varten.
Vain harva tiesi, missä avain oli.
Punainen veneemme kelluu tyynellä vedellä.""",
    "cs": """Kočka spí pod stolem v kuchyni.
Strýc nosí babičce každý čtvrtek noviny.
Co budeme dělat dnes večer po škole?
Čerstvá ryba je v přístavu levnější než ve městě.
Ptáci odlétají na jih, když přichází zima.
Na bílé zdi visely velké dřevěné hodiny.
Dcera lékaře studuje hudbu a filozofii.
Zavři dveře, prosím, je tu průvan.
V lese jsme viděli lišku a dva vlky.
Petr chce na cestu nové kolo.
Málokdo věděl, kde je schovaný klíč.
Po temné vodě plul červený deštník.""",
    "ru": """Кошка спит под столом на кухне.
Дядя каждый четверг приносит бабушке газету.
Что мы будем делать сегодня вечером после школы?
Свежая рыба в порту дешевле, чем в городе.
Птицы летят на юг, когда приходит зима.
На белой стене висели большие часы.
Дочь врача изучает музыку и философию.
Закрой, пожалуйста, дверь, здесь дует.
В лесу мы видели лису и двух волков.
Пётр хочет купить новый велосипед.""",
    "ca": """La mare compra pa i mantega al mercat.
El noi petit fa un castell de sorra vora el mar.
Demà anirem a passejar pel bosc amb els amics.
Un home vell viu tot sol en aquella casa blanca.
Pots obrir la finestra, que fa molta calor?
La lluna il·lumina l'aigua fosca del port.
El gat dorm sota la taula de la cuina.
Què farem aquest vespre després de l'escola?
El peix fresc és més barat al port que a la ciutat.
Els ocells volen cap al sud quan arriba el fred.
La filla del metge estudia música i filosofia.
Tanca la porta, sisplau, que entra massa aire.
Al bosc vam veure una guineu i dos llops.
Poca gent sabia on era la clau vermella.""",
    "hi": """बिल्ली रसोई में मेज़ के नीचे सो रही है।
चाचा हर गुरुवार को दादी के लिए अख़बार लाते हैं।
आज शाम स्कूल के बाद हम क्या करेंगे?
सफ़ेद दीवार पर लकड़ी की एक बड़ी घड़ी थी।
डॉक्टर की बेटी संगीत और विज्ञान पढ़ती है।
दरवाज़ा बंद कर दो, बाहर बहुत ठंड है।
बहुत कम लोग जानते थे कि चाबी कहाँ रखी है।
बाग में फूल खिले हैं और पक्षी गा रहे हैं।""",
}
"""More sentences, for voices that are few a language."""
